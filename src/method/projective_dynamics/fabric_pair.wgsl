// A pair of nodes in the matrix of a cloth of fabric, as one of them sees it.
// Mirror: src/method/projective_dynamics/relaxed_fabric.hpp.
struct FabricPair {
  other : u32,
  stretching : f32,  // N/m: of membranes
  bending : f32,     // N/m
}
