// Holds vertices back from other cloth: the way of a marked one ends before the planes half way between it and all that
// it is listed with, as find_meeting has found. In the last round, where that was not enough, the substep ends before
// its time for all cloth; or, where too much time would be lost, the way of every vertex ends before its planes.
// One invocation per vertex. Source: docs/contact.md, equations (6) and (6h).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/links.wgsl"
#include "contact/proximity/lost_way.wgsl"
#include "contact/proximity/planes.wgsl"
#include "contact/proximity/rounds.wgsl"
#include "contact/proximity/slow.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(5) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(6) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read>       velocity_before : array<vec4f>; // vertex_count      m/s
override kKeepsLost : bool = false;  // as in contact_respond.wgsl, in the first round, behind which ways are shortened
const kDrivenPart = 0.01;  // of the thickness: no rounding

// Equation (6h): a state on the straight line between those at the start and at the end of the substep.
fn end_before_time(vertex : u32, part : f32) {
  let start = previous[vertex];
  if (start.w == 0.0) { return; }
  position[vertex] = vec4f(start.xyz + part * (position[vertex].xyz - start.xyz), start.w);
  let before = velocity_before[vertex].xyz;
  velocity[vertex] = vec4f(before + part * (velocity[vertex].xyz - before), 0.0);
}

@compute @workgroup_size(kWorkgroupSize)
fn hold_back(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  if (atomicLoad(&statistics[kStatMeeting]) < this_round.number) { return; }
  if (this_round.is_last != 0u) {
    let part = part_of_all();
    let delay = u32(ceil(1e6 * step.time.dt * (1.0 - part)));
    if (part > 0.0 && atomicLoad(&statistics[kStatDelayBefore]) + delay <= step.contact.most_delay) {
      if (vertex == 0u) {
        atomicAdd(&statistics[kStatSlowed], 1u);
        atomicAdd(&statistics[kStatDelayUs], delay);
      }
      end_before_time(vertex, part);
      return;
    }
  }
  let held = vertex_contacts[kVertexWords * vertex + kHeldWord];
  let start = previous[vertex];
  if (start.w == 0.0 || (held & kHeld) != 0u) { return; }
  if (this_round.is_last == 0u && (held & kMarked) == 0u) { return; }
  let found = vertex_contacts[kVertexWords * vertex + kPartWord];
  let count_now = found != 0u && (held & kCounted) == 0u;
  vertex_contacts[kVertexWords * vertex + kHeldWord] = held | kHeld | select(0u, kCounted, count_now);
  if (found == 0u) { return; }
  let part = bitcast<f32>(~found);
  if (kKeepsLost && this_round.is_first != 0u) {
    set_lost_way(vertex, lost_way(vertex) + (1.0 - part) * (position[vertex].xyz - start.xyz));
  }
  let end_of_way = start.xyz + part * (position[vertex].xyz - start.xyz);
  position[vertex] = vec4f(end_of_way, start.w);
  velocity[vertex] = vec4f(part * velocity[vertex].xyz, 0.0);
  if (count_now) { atomicAdd(&statistics[kStatTruncated], 1u); }
  var driven = false;  // an obstacle has come past it, and it cannot give way
  for (var link = vertex_contacts[kVertexWords * vertex + kLinkWord]; link != 0u && !driven; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    if (contact.solid != 1u && contact.solid != 2u) { continue; }
    driven = contact.normal.w > 0.0 && beyond(contact, role_of(link), end_of_way) > kDrivenPart * contact.thickness;
  }
  if (driven) { atomicAdd(&statistics[kStatDriven], 1u); }
}
