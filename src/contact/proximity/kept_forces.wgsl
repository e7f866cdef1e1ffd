// The forces of pairs that act, beyond a search, which lists pairs anew: in the buffer `kept`. It has two lists: of the
// last frame's end, with which the next frame begins, also when it is run again; and of the last search within a frame.
// kHeader words: their lengths. Then kKeptWords a pair: its ids, and its force, N, as the bits of f32; the list of the
// frame's end first, each with room for all pairs. The buffer `kept_places` is a hash table with open addressing over
// the list that the search reads: a place in it is the pair's number and 1, or 0; no result depends on the order.
#include "state/contact.wgsl"
#include "state/hash_pair.wgsl"
const kHeader = 8u;
const kKeptWords = 8u;

fn pair_capacity() -> u32 { return (arrayLength(&kept) - kHeader) / (2u * kKeptWords); }
fn kept_word(list : u32, number : u32) -> u32 { return kHeader + kKeptWords * (list * pair_capacity() + number); }
fn hash_of(ids : vec4u) -> u32 { return hash_pair(hash_pair(ids.x, ids.y), hash_pair(ids.z, ids.w)); }
