// Changes the velocities of each piece's nodes by what turn_pieces has found; where drag takes momentum, by nothing.
// One invocation per node of a chunk. Source: docs/momentum.md.
#include "gpu/index.wgsl"
#include "method/pieces/moved_node.wgsl"
#include "state/step.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       lists        : array<u32>;     // chunks.wgsl
@group(0) @binding(2) var<storage, read>       sums         : array<vec4f>;   // kPieceColumns * chunks
@group(0) @binding(3) var<storage, read>       turns        : array<vec4f>;   // kTurnColumns * pieces   m, rad
@group(0) @binding(4) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(5) var<storage, read_write> velocity_out : array<vec4f>;   // vertex_count   m/s

@compute @workgroup_size(kWorkgroupSize)
fn move_steps(@builtin(global_invocation_id) id : vec3u) {
  let moved = moved_node(flat_index(id));
  if (moved.node == kNoNode || step.air.drag != 0.0) { return; }
  let before = velocity_out[moved.node];
  velocity_out[moved.node] = vec4f(before.xyz + moved.by / step.time.dt, before.w);
}
