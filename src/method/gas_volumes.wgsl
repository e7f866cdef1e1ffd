// By how much the volume that a cloth encloses grows as each of its nodes moves, and the volume itself in parts of
// kGasChunk nodes: it is of degree 3 in places, so x · ∂V/∂x is 3 V. One invocation per node of a chunk. Sums run in an
// order that no workgroup size changes. Source: docs/pressure.md, equation 1.
#include "gpu/index.wgsl"
#include "method/corners.wgsl"
#include "method/gas.wgsl"
#include "state/step.wgsl"
//                                                                                elements       unit
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       corners     : array<u32>;       // method/corners.wgsl
@group(0) @binding(2) var<storage, read>       chunks      : array<GasChunk>;
@group(0) @binding(3) var<storage, read>       gases       : array<Gas>;
@group(0) @binding(4) var<storage, read>       position_in : array<vec4f>;     // vertex_count   m (w: 1/kg)
@group(0) @binding(5) var<storage, read>       velocity_in : array<vec4f>;     // vertex_count   m/s
@group(0) @binding(6) var<storage, read_write> slopes      : array<vec4f>;     // vertex_count   m² (w: 1 + gas, or 0)
@group(0) @binding(7) var<storage, read_write> volumes     : array<f32>;       // of each chunk  m³
override kAhead : f32 = 0.0;  // 1: where nodes would go in the substep by their velocities
var<workgroup> lanes : array<f32, kWorkgroupSize>;

fn corner_place(vertex : u32) -> vec3f {
  return position_in[vertex].xyz + kAhead * step.time.dt * velocity_in[vertex].xyz;
}

// What grows with the node is a third of the areas around it.
fn slope_at(node : u32) -> vec3f {
  let own = corner_place(node);
  var sum = vec3f(0.0);
  for (var entry = corners[node]; entry < corners[node + 1u]; entry += 3u) { sum += normal_of(own, entry); }
  return 0.5 * sum;
}

@compute @workgroup_size(kWorkgroupSize)
fn gas_volumes(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) local : u32) {
  let lane = flat_index(id);
  let chunk = lane / kGasChunk;
  let at = lane % kGasChunk;
  var part = 0.0;
  if (chunk < arrayLength(&chunks)) {
    let own = chunks[chunk];
    if (at < own.count) {
      let node = own.first + at;
      let slope = slope_at(node);
      // From a node of the cloth, not from the origin: far away from that f32 would have few digits of the volume.
      let from_first = corner_place(node) - corner_place(gases[own.gas].first_vertex);
      part = dot(from_first, slope) / 3.0;
      slopes[node] = vec4f(slope, f32(1u + own.gas));
    }
  }
  lanes[local] = part;
  workgroupBarrier();
  for (var half = kGasChunk / 2u; half > 0u; half /= 2u) {
    if (at < half) { lanes[local] += lanes[local + half]; }
    workgroupBarrier();
  }
  if (at == 0u && chunk < arrayLength(&chunks)) { volumes[chunk] = lanes[local]; }
}
