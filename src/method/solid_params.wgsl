// A body with volume for its kernels: its nodes, how many tetrahedra it has, and their law. The including kernel binds
// `rests`: three a tetrahedron.
#include "element/tet/law.wgsl"
struct SolidParams {  // mirror: src/method/solid_buffers.hpp
  first : u32,
  count : u32,
  tets : u32,
  first_tet : u32,  // among those of all bodies that kernels have together
  law : SolidLaw,
}

fn rest_of_tet(tet : u32) -> TetRest {
  let b = rests[3u * tet];
  return TetRest(b.xyz, rests[3u * tet + 1u].xyz, rests[3u * tet + 2u].xyz, b.w);
}
