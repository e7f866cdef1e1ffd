// A tile of a coarse level of a grid: one workgroup smooths its nodes, and so many about them that none has to wait for
// another workgroup. What others still read is not written: between the way down and the way up the solution is in
// kSecond. Bindings, and the nodes of a tile; the including kernel has operand(level, x, node).
#include "gpu/index.wgsl"
#include "method/multigrid/coarse_operator.wgsl"
#include "method/multigrid/grid_transfer.wgsl"
#include "method/multigrid/keep_vector.wgsl"
#include "method/multigrid/smoothing.wgsl"
#include "method/multigrid/whole_workgroup.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>             levels    : array<GridLevelParams, 2>;
@group(0) @binding(1) var<storage, read_write> vectors   : array<vec4f>;        // method/multigrid/cloth.wgsl
@group(0) @binding(2) var<storage, read>       operators : array<vec2f>;        // method/multigrid/grid_block.wgsl
const kReach = 2;  // nodes: how far A x looks along a side

// Of a square of nodes, row by row: the k-th, which may lie outside of the grid.
fn in_square(start : vec2i, side : u32, k : u32) -> vec2i { return start + vec2i(vec2u(k % side, k / side)); }
fn is_node(level : Level, at : vec2i) -> bool { return all(at >= vec2i(0)) && all(at < size_of(level)); }
fn size_of(level : Level) -> vec2i { return vec2i(vec2u(level.nx, level.ny)); }
fn node_at(level : Level, at : vec2i) -> u32 { return u32(at.y) * level.nx + u32(at.x); }
fn place_in(level : Level, start : vec2i, side : u32, node : u32) -> u32 {
  let j = node / level.nx;
  let from_start = vec2i(vec2u(node - j * level.nx, j)) - start;
  return u32(from_start.y) * side + u32(from_start.x);
}

// The first node of a workgroup's tile, of so many nodes a side; below the last row past the last tile.
fn tile_start(level : Level, side : u32, group : u32) -> vec2u {
  let across = (level.nx + side - 1u) / side;
  return side * vec2u(group % across, group / across);
}

// For all invocations of a workgroup at once, whose tile begins there.
fn has_work(local : u32, level : Level, first : vec2u) -> bool {
  return !are_all_idle(local, is_solved() || first.y >= level.ny);
}
