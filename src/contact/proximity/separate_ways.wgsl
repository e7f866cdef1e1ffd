// Moves the end of a vertex's way, and its velocity, by what separate_pairs has found, but out of no reach and past no
// obstacle's plane. One invocation per vertex. Source: docs/contact.md, equation (6d).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/solid_planes.wgsl"
#include "contact/proximity/reach.wgsl"
#include "contact/proximity/rounds.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       predicted       : array<vec4f>; // 3 * vertex_count  reach.wgsl
@group(0) @binding(4) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<vec4u>; // 4 * vertex_count: state/contact.wgsl
@group(0) @binding(6) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(7) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn separate_ways(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  if (atomicLoad(&statistics[kStatMeeting]) < this_round.number) { return; }
  let at = kVertexWords / 4u * vertex;
  let words = vertex_contacts[at];
  let sums = array(vertex_contacts[at + 1u], vertex_contacts[at + 2u], vertex_contacts[at + 3u]);
  let change = vec3f(bitcast<vec3i>(sums[0].yzw)) / kSpeedUnits;
  let push = vec3f(bitcast<vec3i>(vec3u(sums[1].w, sums[2].xy))) / kPushUnits;
  if (words[kShareWord] == 0u && all(change == vec3f(0.0)) && all(push == vec3f(0.0))) { return; }
  let start = previous[vertex];
  let end = position[vertex].xyz;
  let found = predicted[step.nodes.count + vertex];
  let wanted = place_within(Reach(found.xyz, found.w, predicted[2u * step.nodes.count + vertex].xyz), end + push);
  let part = part_before_solids(end, wanted, words[kLinkWord]);
  let place = end + part * (wanted - end);
  let goes_far = length(place - start.xyz) > free_way();
  if (goes_far) { atomicStore(&statistics[kStatFarWays], 1u); }
  vertex_contacts[at] = vec4u(words.xy, 0u, words.w);
  vertex_contacts[at + 1u] = vec4u(sums[0].x, 0u, 0u, 0u);
  vertex_contacts[at + 2u] = vec4u(sums[1].xyz, 0u);  // kLostWord
  vertex_contacts[at + 3u] = vec4u(0u, 0u, sums[2].z | select(0u, kFarWay, goes_far), sums[2].w);
  if (start.w == 0.0) { return; }
  position[vertex] = vec4f(place, start.w);
  velocity[vertex] = vec4f(velocity[vertex].xyz + part * change, 0.0);
}
