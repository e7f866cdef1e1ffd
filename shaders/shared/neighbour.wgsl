// One spring as one of its nodes sees it. Mirror: src/element/neighbours.hpp.
struct Neighbour {
  node : u32,
  rest_length : f32,  // m
  stiffness : f32,    // N/m
  damping : f32,      // N·s/m
}
