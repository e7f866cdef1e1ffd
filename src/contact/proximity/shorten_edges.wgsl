// Finds the edges of cloth that would end longer than they begin, and than they would have ended if no way had been
// shortened, by more than what was lost pays for; and how far the end that goes farther may go. One invocation per
// edge. Source: docs/contact.md, equation (6i).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/rounds.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(4) var<storage, read>       edges           : array<vec2u>; // the ends
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> statistics      : array<atomic<u32>>;

override kYielding : f32 = 0.0;  // s: the time in which an edge gives way

fn is_shortened(vertex : u32) -> bool {
  return (atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kCounted) != 0u;
}

fn lost_way(vertex : u32) -> vec3f {
  let word = kVertexWords * vertex + kLostWord;
  return vec3f(bitcast<f32>(atomicLoad(&vertex_contacts[word])), bitcast<f32>(atomicLoad(&vertex_contacts[word + 1u])),
               bitcast<f32>(atomicLoad(&vertex_contacts[word + 2u])));
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
  if (!(is_shortened(edge.x) || is_shortened(edge.y))) { return; }
  let start = previous[edge.y].xyz - previous[edge.x].xyz;
  let end = position[edge.y].xyz - position[edge.x].xyz;
  let lost_a = lost_way(edge.x);
  let lost_b = lost_way(edge.y);
  let paid = min(1.0, kYielding / step.time.dt) * max(length(lost_a), length(lost_b));
  let longest = max(length(start), length(end + lost_b - lost_a)) + paid;
  if (length(end) <= kBeyond * longest) { return; }
  let way_a = position[edge.x].xyz - previous[edge.x].xyz;
  let way_b = position[edge.y].xyz - previous[edge.y].xyz;
  let far_a = select(dot(way_a, way_a), -1.0, previous[edge.x].w == 0.0);  // what the scene moves goes its way
  let far_b = select(dot(way_b, way_b), -1.0, previous[edge.y].w == 0.0);
  if (far_a >= far_b) { end_before(edge.x, part_within(start + way_b, -way_a, longest)); }
  if (far_b >= far_a) { end_before(edge.y, part_within(start - way_a, way_b, longest)); }
  atomicMax(&statistics[kStatMeeting], this_round.number);
}
