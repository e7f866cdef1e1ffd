// Mirror: Spring in src/model/host_model.hpp.
struct Spring {
  node_a : u32,
  node_b : u32,
  rest_length : f32,  // m
  stiffness : f32,    // N/m
  damping : f32,      // N·s/m
}
