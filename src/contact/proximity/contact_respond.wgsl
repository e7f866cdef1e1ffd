// The end of a substep's contact for a vertex: the velocity change of its pairs, hold_back, and whether the
// next substep searches. Clears its words for that substep. One invocation per vertex.
// Source: docs/contact.md, equations (6) and (7d).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/leave_bodies.wgsl"
#include "contact/proximity/hold_back.wgsl"
#include "contact/proximity/schedule_search.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // 2 * vertex_count  m/s, then m
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read>       entries         : array<u32>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<vec4u>; // 2 * vertex_count: state/contact.wgsl
@group(0) @binding(6) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(7) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;

// Takes the sum that `contact_impulse` has left for a vertex, and clears it [m/s].
fn take_impulses(vertex : u32) -> vec3f {
  let more = vertex_contacts[2u * vertex + 1u];
  vertex_contacts[2u * vertex + 1u] = vec4u(more.x, 0u, 0u, 0u);
  let sum = bitcast<vec3i>(more.yzw);
  return vec3f(sum) / kSpeedUnits;
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_respond(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  let words = vertex_contacts[2u * vertex];
  let begin = words.x;
  let end = begin + words.y;
  let acted_on = words[kUrgencyWord] != 0u;
  let tight = bitcast<f32>(words[kTightWord]);
  // Cleared for the next substep.
  if (acted_on || tight > 0.0) { vertex_contacts[2u * vertex] = vec4u(begin, words.y, 0u, 0u); }
  if (vertex == 0u) { schedule_for_colliders(); }

  let found = predicted[step.nodes.count + vertex];
  let start = previous[vertex];
  let inverse_mass = start.w;
  let unhindered = position[vertex].xyz;
  var way = Way(unhindered, predicted[vertex].xyz, false);
  if (inverse_mass > 0.0) {
    if (acted_on) {
      let change = take_impulses(vertex);
      way.velocity += change;
      way.position += step.time.dt * change;
    }
    if (tight >= kInBody) {
      let change = out_of_body(bodies_around(begin, end), way.velocity);
      way.velocity += change;
      way.position += step.time.dt * change;
    }
    way = within_reach(way, start.xyz, found);
    way = before_planes(way, start.xyz, begin, end, tight);
    if (way.held_back) {  // it has the velocity that it came by, or its neighbours would pull it ever faster
      way.velocity = (way.position - start.xyz) / step.time.dt;
      atomicAdd(&statistics[kStatTruncated], 1u);
    }
    position[vertex] = vec4f(way.position, inverse_mass);
  }
  // An impulse breaks the motion that an implicit solver extrapolates (Method::history), so its history is invalid.
  let untouched = all(way.velocity == predicted[vertex].xyz) && all(way.position == unhindered);
  velocity[vertex] = vec4f(way.velocity, select(0.0, predicted[vertex].w, untouched));
  schedule_for_vertex(length(way.position - found.xyz), length(way.position - start.xyz), found.w);
}
