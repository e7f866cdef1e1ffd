// One substep of a grid cloth, prediction included: gathers the forces of a node's springs and integrates it. One
// invocation per node; a workgroup has nodes of several rows, which share most of what they read.
// Source: docs/solvers/mass_spring.md, "node-centric".
#include "method/mass_spring/grid_springs.wgsl"
#include "gpu/index.wgsl"
#include "state/integrate.wgsl"
//                                                                               elements            unit
@group(0) @binding(0) var<uniform>             step         : StepParams;
@group(0) @binding(1) var<uniform>             grid         : GridParams;
@group(0) @binding(2) var<storage, read>       position_in  : array<vec4f>;   // vertex_count        m (w: inverse mass, 1/kg)
@group(0) @binding(3) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count        m/s
@group(0) @binding(4) var<storage, read>       rest         : array<vec4f>;   // vertex_count        m (w: motion)
@group(0) @binding(5) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(6) var<storage, read_write> position_out : array<vec4f>;   // vertex_count        m
@group(0) @binding(7) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count        m/s

fn position_at(node : u32) -> vec3f { return position_in[node].xyz; }
fn velocity_at(node : u32) -> vec3f { return velocity_in[node].xyz; }

@compute @workgroup_size(kWorkgroupSize)
fn advance_grid(@builtin(workgroup_id) group : vec3u, @builtin(local_invocation_index) local : u32) {
  let tile = flat_group(group);
  let tile_j = tile / grid.tiles_x;
  let local_j = local / grid.tile_width;
  let i = (tile - tile_j * grid.tiles_x) * grid.tile_width + local - local_j * grid.tile_width;
  let j = tile_j * (kWorkgroupSize / grid.tile_width) + local_j;
  if (i >= grid.nx || j >= grid.ny) { return; }
  let node = grid.first_vertex + j * grid.nx + i;
  let before = NodeState(position_in[node], velocity_in[node]);
  var after : NodeState;
  if (before.position.w == 0.0) {
    after = integrate_held(before, rest[node]);
  } else if (is_grabbed(node)) {
    after = integrate_grabbed(node, before);
  } else {
    after = integrate_free(before, grid_force(before.position.xyz, before.velocity.xyz, node, grid.nx, i, j));
  }
  position_out[node] = after.position;
  velocity_out[node] = after.velocity;
}
