// Finds the edges of cloth that would end longer than their strain limit, and longer than they begin, since the way of
// an end was shortened; and how far the end that goes farther may go. One invocation per edge. Source: docs/contact.md,
// equation (6i).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/limited_edge.wgsl"
#include "contact/proximity/rounds.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(4) var<storage, read>       edges           : array<LimitedEdge>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> statistics      : array<atomic<u32>>;

fn is_shortened(vertex : u32) -> bool {
  return (atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kCounted) != 0u;
}

fn end_before(vertex : u32, part : f32) {
  atomicMax(&vertex_contacts[kVertexWords * vertex + kShareWord], ~bitcast<u32>(part));
}

// How much of its way an edge's end may go that makes it no longer than `longest`, if it is `begin` without that; where
// no part does, the one that makes it shortest.
fn part_within(begin : vec3f, way : vec3f, longest : f32) -> f32 {
  let a = dot(way, way);
  let b = dot(begin, way);
  let root = max(0.0, b * b - a * (dot(begin, begin) - longest * longest));
  return clamp((sqrt(root) - b) / a, 0.0, 1.0);
}

@compute @workgroup_size(kWorkgroupSize)
fn shorten_edges(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= arrayLength(&edges) || round_is_idle(false)) { return; }
  let edge = edges[index];
  let start = previous[edge.b].xyz - previous[edge.a].xyz;
  let end = position[edge.b].xyz - position[edge.a].xyz;
  let longest = max(edge.longest, length(start));
  if (length(end) <= kBeyond * longest || !(is_shortened(edge.a) || is_shortened(edge.b))) { return; }
  let way_a = position[edge.a].xyz - previous[edge.a].xyz;
  let way_b = position[edge.b].xyz - previous[edge.b].xyz;
  let far_a = select(dot(way_a, way_a), -1.0, previous[edge.a].w == 0.0);  // what the scene moves goes its way
  let far_b = select(dot(way_b, way_b), -1.0, previous[edge.b].w == 0.0);
  if (far_a >= far_b) { end_before(edge.a, part_within(start + way_b, -way_a, longest)); }
  if (far_b >= far_a) { end_before(edge.b, part_within(start - way_a, way_b, longest)); }
  atomicMax(&statistics[kStatMeeting], this_round.number);
}
