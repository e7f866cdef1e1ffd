// What obstacles ask of the nodes in a substep, three words each after a word of the method's own in `aim`: the
// direction in which they press it, and how far along it the node has to go at least, m; the way of their surface, m,
// and μ; how much of the first restores a gap, m, one of the states, 1 where all that presses the node has about one
// direction, and how fast a node that bears has to leave the surface at least, m/s.
// The including kernel binds `step` and `aim`. Mirror: src/method/holds/reference/node_hold.cpp.
#include "state/step.wgsl"
const kFree = 0.0;
const kPressed = 1.0;
const kBears = 2.0;  // and the obstacle presses it, as far as the method has come

fn hold_at(node : u32) -> u32 { return step.nodes.count + 3u * node; }
