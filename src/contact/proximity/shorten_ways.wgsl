// Ends the ways of vertices where shorten_edges has found that they may go, but behind no obstacle's plane, and their
// velocities with them. One invocation per vertex. Source: docs/contact.md, equation (6i).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/lost_way.wgsl"
#include "contact/proximity/rounds.wgsl"
#include "contact/proximity/solid_planes.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;
@group(0) @binding(5) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(6) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn shorten_ways(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  if (!round_is_idle(true)) { shorten_way(vertex); }
  let counted = (vertex_contacts[kVertexWords * vertex + kHeldWord] & kCounted) != 0u;
  if (this_round.is_last != 0u && counted) { set_lost_way(vertex, vec3f(0.0)); }  // cleared for the next substep
}

fn shorten_way(vertex : u32) {
  let found = vertex_contacts[kVertexWords * vertex + kShareWord];
  if (found == 0u) { return; }
  vertex_contacts[kVertexWords * vertex + kShareWord] = 0u;
  let start = previous[vertex];
  if (start.w == 0.0) { return; }
  let end = position[vertex].xyz;
  let way = end - start.xyz;
  let less = 1.0 - bitcast<f32>(~found);
  let link = vertex_contacts[kVertexWords * vertex + kLinkWord];
  let part = 1.0 - less * part_before_solids(end, end - less * way, link);
  if (part == 1.0) { return; }
  set_lost_way(vertex, lost_way(vertex) + (1.0 - part) * way);
  position[vertex] = vec4f(start.xyz + part * way, start.w);
  velocity[vertex] = vec4f(part * velocity[vertex].xyz, 0.0);
  let held = vertex_contacts[kVertexWords * vertex + kHeldWord];
  if ((held & kCounted) == 0u) {
    vertex_contacts[kVertexWords * vertex + kHeldWord] = held | kCounted;
    atomicAdd(&statistics[kStatTruncated], 1u);
  }
}
