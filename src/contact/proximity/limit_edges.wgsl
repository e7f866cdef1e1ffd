// Keeps edges of cloth within their strain limit, as a blow between their ends that gives no energy and adds no
// momentum: an edge that would end longer than that, and longer than it begins, ends no longer. It shares the masses of
// its ends with what else moves them in this round: at first it counts, as kGives it adds what it moves them by, and
// their velocities likewise. One invocation per edge. Source: docs/contact.md, equation (6f).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/limited_edge.wgsl"
#include "contact/proximity/rounds.wgsl"
#include "contact/proximity/sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(4) var<storage, read>       velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(5) var<storage, read>       edges           : array<LimitedEdge>;
@group(0) @binding(6) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
override kGives : bool = false;

@compute @workgroup_size(kWorkgroupSize)
fn limit_edges(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= arrayLength(&edges) || round_is_idle(kGives)) { return; }
  let edge = edges[index];
  let start = previous[edge.b].xyz - previous[edge.a].xyz;
  let end = position[edge.b].xyz - position[edge.a].xyz;
  let size = length(end);
  let longest = max(edge.longest, length(start));
  if (size <= kBeyond * longest) { return; }
  let mobility = vec2f(previous[edge.a].w, previous[edge.b].w);  // 1/kg
  if (!kGives) {
    if (mobility.x > 0.0) { share_mass(edge.a); }
    if (mobility.y > 0.0) { share_mass(edge.b); }
    atomicMax(&statistics[kStatMeeting], this_round.number);
    return;
  }
  let n = end / size;
  let by_speed = max(0.0, dot(n, start + step.time.dt * (velocity[edge.b].xyz - velocity[edge.a].xyz)) - longest);
  let parts = mobility / dot(mobility, vec2f(share_count(edge.a), share_count(edge.b)));
  move_by(edge.a, parts.x * (size - longest), parts.x * by_speed / step.time.dt, n);
  move_by(edge.b, parts.y * (size - longest), parts.y * by_speed / step.time.dt, -n);
}
