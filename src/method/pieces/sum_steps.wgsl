// The sums of pieces' nodes in parts of kPieceChunk, from places and velocities before and after a substep in which
// nothing but gravity came from outside. One invocation per node of a chunk; sums run in an order that no workgroup
// size changes. Source: docs/momentum.md.
#include "gpu/index.wgsl"
#include "method/pieces/sum_chunks.wgsl"
#include "state/grab.wgsl"
//                                                                               elements       unit
@group(0) @binding(0) var<uniform>             step         : StepBlock;
@group(0) @binding(1) var<storage, read>       lists        : array<u32>;     // chunks.wgsl
@group(0) @binding(2) var<storage, read>       rest         : array<vec4f>;   // vertex_count   m (w: motion)
@group(0) @binding(3) var<storage, read>       motions      : array<vec4f>;   // 3 * motions * substeps
@group(0) @binding(4) var<storage, read>       position_in  : array<vec4f>;   // vertex_count   m (w: 1/kg)
@group(0) @binding(5) var<storage, read>       velocity_in  : array<vec4f>;   // vertex_count   m/s
@group(0) @binding(6) var<storage, read>       position_out : array<vec4f>;   // vertex_count   m
@group(0) @binding(7) var<storage, read>       velocity_out : array<vec4f>;   // vertex_count   m/s (w < 0: held)
@group(0) @binding(8) var<storage, read_write> sums         : array<vec4f>;   // kPieceColumns * chunks

override kJoins : bool = false;  // true: pieces of several bodies, which may hold each other
const kHeldByOther = -3.0;       // of a velocity's w: mirror: method/multigrid/pair_finish.wgsl

fn goes_free(node : u32) -> bool {
  let w = velocity_out[node].w;
  return (w >= 0.0 || (kJoins && w == kHeldByOther)) && !is_grabbed(node);
}

fn sums_of(node : u32, first_node : u32) -> mat4x4f {
  if (!goes_free(node)) { return held_sums(); }
  let dt = step.time.dt;
  let now = position_in[node];
  let fall = dt * dt * step.air.acceleration.xyz;
  let after = dt * velocity_out[node].xyz;
  let e = after - dt * velocity_in[node].xyz - fall;
  // A step of second order falls by half of that less than its velocity at the end says.
  let less = select(0.0, 0.5, step.time.step_ratio * velocity_in[node].w > 0.0);
  let beside = position_out[node].xyz - now.xyz - after + less * fall;
  return node_sums(1.0 / now.w, now.xyz - position_in[first_node].xyz, e, cross(beside, after));
}

@compute @workgroup_size(kWorkgroupSize)
fn sum_steps(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  sum_chunk(flat_index(id), local);
}
