// Between two iterations of impulses: gives each vertex the sum of the one before, so that the next begins from there.
// One invocation per vertex. Source: docs/contact.md, Impulse.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/impulse_moves.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read_write> predicted       : array<vec4f>; // vertex_count      m/s
@group(0) @binding(2) var<storage, read_write> vertex_contacts : array<vec4u>; // 4 * vertex_count: state/contact.wgsl
@group(0) @binding(3) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(4) var<storage, read>       statistics      : array<u32>;
override kWherePressed : u32 = 0;  // as in contact_impulse.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn add_impulses(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  if (kWherePressed != 0u && !cloth_is_pressed(statistics[kStatPressed])) { return; }
  let words = kVertexWords / 4u * vertex;
  let changes = vertex_contacts[words + 1u];
  let first = vertex_contacts[words + 2u];
  let sum = bitcast<vec3i>(changes.yzw) + bitcast<vec3i>(first.xyz);
  if (all(sum == vec3i(0))) { return; }
  vertex_contacts[words + 1u] = vec4u(changes.x, 0u, 0u, 0u);
  vertex_contacts[words + 2u] = vec4u(0u, 0u, 0u, first.w);
  let change = vec3f(sum) / kSpeedUnits;
  let v = predicted[vertex];
  predicted[vertex] = vec4f(v.xyz + change, 0.0);  // w: no part of a smooth motion (Method::history)
  if (!impulses_move(vertex_contacts[words + 3u].z)) { return; }
  let x = position[vertex];
  if (x.w > 0.0) { position[vertex] = vec4f(x.xyz + step.time.dt * change, x.w); }
}
