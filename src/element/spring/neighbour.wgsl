// One spring as one of its nodes sees it. Mirror: src/element/spring/neighbours.hpp.
struct Neighbour {
  node_and_kind : u32,  // the kind in the upper four bits
  rest_length : f32,    // m
}
const kNeighbourKinds = 16u;
const kNeighbourNodeBits = 28u;
// The entries of this many consecutive nodes are interleaved: adjacent invocations read words beside
// each other.
const kSlice = 32u;

struct SpringKinds {  // mirror: src/method/projective_dynamics/relaxed_springs.hpp
  kinds : array<vec4f, kNeighbourKinds>,  // N/m, N·s/m: stiffness and damping
}
