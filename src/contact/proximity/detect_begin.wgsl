// Begins a search if one is due: the step demands it, or a vertex leaves its reach. Records where each vertex is and
// where it may go until the next search, and clears the counts of the lists. One invocation per vertex.
// Source: docs/contact.md, Reach.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       position        : array<vec4f>; // vertex_count      m
@group(0) @binding(2) var<storage, read>       motion          : array<vec4f>; // vertex_count      see kPredicted
@group(0) @binding(3) var<storage, read_write> predicted       : array<vec4f>; // 3 * vertex_count  m: reach.wgsl
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<u32>;   // kVertexWords * vertex_count
@group(0) @binding(5) var<storage, read_write> statistics      : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read>       most_slack      : array<f32>;   // vertex_count      m
override kPredicted : bool = true;       // `motion` has where vertices come in this substep, m; false: velocities, m/s
override kIsFirst : bool = true;         // false: the substep has searched before it was predicted, if it demands that

// A vertex has a ball of a thickness, since what is at rest may be struck before the next search, or of its way for
// some time, but none larger than lets flat cloth list nothing of itself. A faster one goes on along its way, too:
// for as many substeps as are to come before that.
const kReachIntervals = 2.5;  // of the substeps between two chances to search
const kFarthest = 4.0;  // of most_reach: how far along its way, if the next search comes before that
fn way_ahead(v : vec3f, way : f32, slack : f32) -> vec3f {
  let soon = kReachMargin * kDetectInterval;
  if (soon * way <= slack) { return vec3f(0.0); }
  return clamp(kFarthest * step.contact.most_reach / way, soon, kReachIntervals * kDetectInterval) * step.time.dt * v;
}

// How far a blow takes a vertex, and where, as expect_blows has found: the way ahead of what has none. That it may go
// beside it is slack; what goes a way of its own has the whole of it as slack, but no more than some.
const kMostBlow = 2.0;      // of `most_slack`
const kStruckFaster = 2.0;  // of what a rigid body strikes, by its own speed
const kBesideBlow = 0.25;   // of the blow
fn expected_blow(at : u32) -> vec3f {
  let size = bitcast<f32>(vertex_contacts[at + kBlowWord]);
  if (size == 0.0) { return vec3f(0.0); }
  vertex_contacts[at + kBlowWord] = 0u;
  var sum = vec3f(0.0);
  for (var axis = 0u; axis < 3u; axis++) {
    sum[axis] = f32(bitcast<i32>(vertex_contacts[at + kChangeWord + axis]));
    vertex_contacts[at + kChangeWord + axis] = 0u;
  }
  return select(vec3f(0.0), size / length(sum) * sum, any(sum != vec3f(0.0)));
}

// How far a collider, or a vertex that the scene moves, may go.
fn scripted_reach() -> f32 {
  let travel = step.contact.collider_travel;
  let kept = min(kReachIntervals * kDetectInterval * travel, step.contact.most_reach);
  return max(kept, kReachMargin * kDetectInterval * travel);
}

// The same of rigid bodies, which may be struck or fall.
fn rigid_reach() -> f32 {
  let travel = bitcast<f32>(atomicLoad(&statistics[kStatBodyTravel]));
  if (travel <= 0.0) { return 0.0; }
  let dt = step.time.dt;
  let faster = kDetectInterval * dt * dt * length(step.air.acceleration.xyz);
  return max(kReachMargin * kDetectInterval * (travel + faster),
             min(step.contact.thickness, step.contact.most_reach));
}

@compute @workgroup_size(kWorkgroupSize)
fn detect_begin(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  let wanted = (kIsFirst && step.contact.detect == kDetectAlways) ||
               (step.contact.detect != kDetectNo && atomicLoad(&statistics[kStatDetect]) != 0u);
  let due = wanted && atomicLoad(&statistics[kStatRolledBack]) == 0u;
  if (vertex == 0u) {
    atomicStore(&statistics[kStatDue], select(0u, 1u, due));
    if (due) {
      atomicStore(&statistics[kStatReach], bitcast<u32>(max(scripted_reach(), rigid_reach())));
      atomicStore(&statistics[kStatTravel], 0u);
      atomicAdd(&statistics[kStatDetections], 1u);
      atomicStore(&statistics[kStatCrossingsLeft], 0u);
      atomicStore(&statistics[kStatCandidates], 0u);
      atomicStore(&statistics[kStatNearBefore], atomicLoad(&statistics[kStatNear]));
      atomicStore(&statistics[kStatPairs], 0u);
      atomicStore(&statistics[kStatNear], 0u);
    }
  }
  if (!due || vertex >= step.nodes.count) { return; }
  let place = position[vertex];
  // The mean velocity until the next search, by the load: what starts to fall must not be held where it was.
  var v = motion[vertex].xyz;
  if (kPredicted) { v = (v - place.xyz) / step.time.dt; }
  v += 0.5 * kReachMargin * kDetectInterval * step.time.dt * step.air.acceleration.xyz;
  let most = most_slack[vertex];
  let way = min(step.time.dt * length(v), 3e38);  // m, in a substep
  var slack = clamp(kReachIntervals * kDetectInterval * way, min(step.contact.thickness, most), most);
  // A rigid body gives what it strikes its own speed, and some nodes more at first, which no way tells before.
  let struck = kStruckFaster * kDetectInterval * (1.0 + step.contact.restitution) *
               bitcast<f32>(atomicLoad(&statistics[kStatBodyTravel]));
  slack = max(slack, min(struck, kMostBlow * most));
  var ahead = way_ahead(v, way, slack);
  if (kPredicted && !kIsFirst) {
    let blow = expected_blow(kVertexWords * vertex);
    let stays = all(ahead == vec3f(0.0));
    slack = max(slack, min(select(1.0, kBesideBlow, stays) * length(blow), kMostBlow * most));
    ahead = select(ahead, blow, stays);
  }
  if (place.w == 0.0) {
    slack = scripted_reach();
    ahead = vec3f(0.0);
  }
  predicted[step.nodes.count + vertex] = vec4f(place.xyz, slack);
  predicted[2u * step.nodes.count + vertex] = vec4f(ahead, 0.0);
  vertex_contacts[kVertexWords * vertex + kLinkWord] = 0u;
  vertex_contacts[kVertexWords * vertex + kTangledWord] = 0u;
  if (step.contact.detect == kDetectAlways) {  // the first substep of a frame, whatever the one before it was
    for (var word = 0u; word < kVertexWords; word++) { vertex_contacts[kVertexWords * vertex + word] = 0u; }
  }
}
