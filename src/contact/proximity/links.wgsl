// The records of a vertex, one after the other. The including kernel binds `contacts`.
#include "state/contact.wgsl"

fn next_of(link : u32) -> u32 { return contacts[record_of(link)].next[role_of(link)]; }
