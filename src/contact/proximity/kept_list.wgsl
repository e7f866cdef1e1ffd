// Which list of kept forces a search reads: in the first search of a frame what the last frame has left. The including
// kernel binds `step`.
#include "state/step.wgsl"
override kStarts : bool = true;  // false: in the first substep of a frame there has been a search before this one
fn kept_list() -> u32 { return select(1u, 0u, kStarts & (step.contact.detect == kDetectAlways)); }
