// A pair of nodes in the matrix of a cloth of fabric, as one of them sees it.
// Mirror: src/method/projective_dynamics/relaxed_fabric.hpp.
struct FabricPair {
  other : u32,
  pull : f32,     // N/m
  damping : f32,  // N·s/m
  bending : f32,  // N/m: the part of the pull that is bending's
}
