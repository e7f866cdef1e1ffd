// Bindings of the kernels of conjugate gradients that grids and meshes share: the finest level as a row of nodes.
#include "gpu/index.wgsl"
#include "method/multigrid/cloth.wgsl"
#include "method/multigrid/chebyshev.wgsl"
#include "method/multigrid/partial_sums.wgsl"
#include "method/multigrid/solve.wgsl"
//                                                                                elements
@group(0) @binding(0) var<uniform>             nodes    : ClothNodes;
@group(0) @binding(1) var<storage, read_write> vectors  : array<vec4f>;       // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read_write> partials : array<vec2f>;       // one a kChunk nodes
struct Level { count : u32, vectors : u32 }

fn finest() -> Level { return Level(nodes.count, nodes.vectors); }
fn vector_at(level : Level, vector : u32, node : u32) -> u32 {
  return cloth * level.vectors + vector * level.count + node;
}
