// A cloth of fabric for its kernels: its nodes, how many triangles and hinges it has, and its membranes' law.
#include "element/membrane/law.wgsl"
struct FabricParams {  // mirror: src/method/fabric_buffers.hpp
  first : u32,
  count : u32,
  triangles : u32,
  hinges : u32,
  law : MembraneLaw,
}
