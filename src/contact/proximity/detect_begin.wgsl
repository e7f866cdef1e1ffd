// Begins a search if one is due: the step demands it, or a vertex is about to leave its reach. Records where each
// vertex is and how far it may go until the next search, and clears the counts of the lists. One invocation per vertex.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       position        : array<vec4f>; // vertex_count      m
@group(0) @binding(2) var<storage, read>       velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(3) var<storage, read_write> predicted       : array<vec4f>; // 2 * vertex_count  m/s, then m
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;   // kVertexWords * vertex_count
@group(0) @binding(5) var<storage, read_write> statistics      : array<atomic<u32>>;

// A slow vertex keeps its reach for kReachSteps substeps. A fast one has no more than lets flat cloth list nothing of
// itself, unless it would leave that before the next detection.
const kReachSteps = 10.0;
const kFastest = 4.0;  // of most_reach
fn reach_of(v : vec3f) -> f32 {
  let way = min(step.time.dt * length(v), 3e38);
  let soon = kReachMargin * kDetectInterval * way;
  let most = step.contact.most_reach;
  return clamp(max(min(kReachSteps * way, most), soon), step.contact.least_reach, kFastest * most);
}

// How far a collider, or a vertex that the scene moves, may go.
fn scripted_reach() -> f32 {
  let travel = step.contact.collider_travel;
  return max(min(kReachSteps * travel, step.contact.most_reach), kReachMargin * kDetectInterval * travel);
}

@compute @workgroup_size(kWorkgroupSize)
fn detect_begin(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  let wanted = step.contact.detect == kDetectAlways ||
               (step.contact.detect == kDetectIfDue && atomicLoad(&statistics[kStatDetect]) != 0u);
  let due = wanted && atomicLoad(&statistics[kStatRolledBack]) == 0u;
  if (vertex == 0u) {
    atomicStore(&statistics[kStatDue], select(0u, 1u, due));
    if (due) {
      atomicStore(&statistics[kStatReach], bitcast<u32>(scripted_reach()));
      atomicStore(&statistics[kStatTravel], 0u);
      atomicAdd(&statistics[kStatDetections], 1u);
      atomicStore(&statistics[kStatCrossingsLeft], 0u);
      atomicStore(&statistics[kStatCandidates], 0u);
      atomicStore(&statistics[kStatPairs], 0u);
      atomicStore(&statistics[kStatEntries], 0u);
    }
  }
  if (!due || vertex >= step.nodes.count) { return; }
  let place = position[vertex];
  var reach = reach_of(velocity[vertex].xyz);
  if (place.w == 0.0) { reach = scripted_reach(); }
  predicted[step.nodes.count + vertex] = vec4f(place.xyz, reach);
  vertex_contacts[kVertexWords * vertex + 1u] = 0u;
  vertex_contacts[kVertexWords * vertex + kCursorWord] = 0u;
  if (step.contact.detect == kDetectAlways) {  // the first substep of a frame, whatever the one before it was
    vertex_contacts[kVertexWords * vertex + kUrgencyWord] = 0u;
    vertex_contacts[kVertexWords * vertex + kTightWord] = 0u;
    for (var axis = 0u; axis < 3u; axis++) { vertex_contacts[kVertexWords * vertex + kChangeWord + axis] = 0u; }
  }
}
