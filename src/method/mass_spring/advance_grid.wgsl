// One substep of a grid cloth, prediction included: gathers the forces of a node's springs and integrates it. One
// invocation per node, equal cloths along z; a workgroup has nodes of several rows, which share most of their reads.
// Source: docs/solvers/mass_spring.md, "node-centric".
#include "method/mass_spring/grid_force.wgsl"
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<uniform>             grid         : SpringGrid;
@group(0) @binding(2) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count        m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s

override kTileWidth : u32;  // nodes of a workgroup along i; a power of two
override kTilesX : u32;     // workgroups beside each other

fn position_at(node : u32) -> vec3f { return position_in[node].xyz; }
fn velocity_at(node : u32) -> vec3f { return velocity_in[node].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn advance_grid(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let tile = flat_group(group);
  let tile_j = tile / kTilesX;
  let local_j = local / kTileWidth;
  let i = (tile - tile_j * kTilesX) * kTileWidth + local - local_j * kTileWidth;
  let j = tile_j * (kWorkgroupSize / kTileWidth) + local_j;
  if (i >= grid.nx || j >= grid.ny) { return; }
  let node = grid.first_vertex + (group.z * grid.ny + j) * grid.nx + i;
  let before = NodeState(position_in[node], velocity_in[node]);
  let force = grid_force(Own(before.position.xyz, before.velocity.xyz), node, grid.nx, i, j);
  let after = integrate_node(node, before, force);
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
