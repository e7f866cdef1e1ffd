// A level of the hierarchy of a cloth that is a mesh, and its place in the buffers of all its levels. Its matrix is
// symmetric, of symmetric blocks, and kept by rows: an entry for the node itself, and then one for each node that it is
// coupled with. Source: docs/solvers/multigrid.md.
#include "method/multigrid/cloth.wgsl"
struct MeshLevelParams {  // mirror: src/method/multigrid/mesh_lists.hpp
  node_count : u32,     // 0: there is no such level
  block_count : u32,    // that differ: an entry of the diagonal or the two of two nodes that are coupled
  first_vector : u32,   // in `vectors`, in vec4f
  first_row : u32,      // of its nodes, in `row_starts`
  first_source : u32,   // the same, in `source_starts`
  first_product : u32,  // of its blocks, in `product_starts` and `targets`
  first_taps : u32,     // of the next finer level's nodes, in `taps`
  padding : u32,
}
// The level type of the files that grids and meshes share. A kernel's uniform `levels` has the level that it works
// on, and the next coarser one.
alias Level = MeshLevelParams;

// A weighted reference. Mirror: src/mesh/coarse_mesh.hpp.
struct Share { index : u32, weight : f32 }
override kTaps : u32 = 3u;  // of a node; mirror: src/method/multigrid/mesh_lists.hpp

// The invocations that take the entries of a row in turns.
const kLanes = 4u;  // mirror: src/method/multigrid/mesh_lists.hpp

fn node_count(level : Level) -> u32 { return level.node_count; }
fn vector_at(level : Level, vector : u32, node : u32) -> u32 {
  return level.first_vector + vector * level.node_count + node;
}
