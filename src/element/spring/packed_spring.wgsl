// Mirror: PackedSpring in src/element/spring/packed_springs.hpp.
struct Spring {
  node_a : u32,
  node_b_and_kind : u32,  // the kind in the upper eight bits
  rest_length : f32,      // m
}
const kSpringNodeBits = 24u;
struct SpringKind {
  stiffness : f32,  // N/m
  damping : f32,    // N·s/m
}
