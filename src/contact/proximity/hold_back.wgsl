// Holds vertices back from other cloth: the way of a marked one ends before the planes half way between it and all that
// it is listed with. In the second round, where that was not enough, that of every vertex. One invocation per vertex.
// Source: docs/contact.md, equation (6).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/planes.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(3) var<storage, read>       entries         : array<u32>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(5) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(6) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
override kRound : u32 = 1;
const kDrivenPart = 0.01;  // of the thickness: no rounding

// How much of a way takes a vertex past no plane, by how far it is beyond it at the start and would be at the end.
fn part_before(now : f32, then : f32) -> f32 {
  if (then <= 0.0) { return 1.0; }
  if (now < 0.0) { return now / (now - then); }
  return select(1.0, 0.0, then > now);
}

@compute @workgroup_size(kWorkgroupSize)
fn hold_back(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  if (atomicLoad(&statistics[select(kStatMeeting, kStatStillMeeting, kRound == 2u)]) == 0u) { return; }
  let begin = vertex_contacts[kVertexWords * vertex];
  let end = begin + vertex_contacts[kVertexWords * vertex + 1u];
  let held = vertex_contacts[kVertexWords * vertex + kHeldWord];
  let start = previous[vertex];
  if (begin >= end || start.w == 0.0 || (held & kHeld) != 0u) { return; }
  if (kRound == 1u && (held & kMarked) == 0u) { return; }
  let wanted = position[vertex].xyz;
  var part = 1.0;
  for (var k = begin; k < end; k++) {
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.solid != 0u || contact.normal.w <= 0.0) { continue; }
    let role = entries[k] & 3u;
    part = min(part, part_before(beyond(contact, role, start.xyz), beyond(contact, role, wanted)));
  }
  let count_now = part < 1.0 && (held & kCounted) == 0u;
  vertex_contacts[kVertexWords * vertex + kHeldWord] = held | kHeld | select(0u, kCounted, count_now);
  if (part >= 1.0) { return; }
  let end_of_way = start.xyz + part * (wanted - start.xyz);
  position[vertex] = vec4f(end_of_way, start.w);
  velocity[vertex] = vec4f(part * velocity[vertex].xyz, 0.0);
  if (count_now) { atomicAdd(&statistics[kStatTruncated], 1u); }
  var driven = false;  // an obstacle has come past it, and it cannot give way
  for (var k = begin; k < end && !driven; k++) {
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.solid != 1u && contact.solid != 2u) { continue; }
    driven = contact.normal.w > 0.0 && beyond(contact, entries[k] & 3u, end_of_way) > kDrivenPart * contact.thickness;
  }
  if (driven) { atomicAdd(&statistics[kStatDriven], 1u); }
}
