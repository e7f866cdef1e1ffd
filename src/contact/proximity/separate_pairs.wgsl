// Separates pairs of cloth whose sides may meet on their ways, as a blow that gives no energy and adds no momentum:
// what comes too near ends as far apart as it begins. Such pairs share the masses of their vertices: at first it
// counts, at each vertex, the pairs that would move it; as kGives it adds what they move it by, and their velocities
// likewise. Not beside crossings, which are driven apart: what a blow kept of that would grow from substep to substep.
// Grid-stride loop over the pairs. Source: docs/contact.md, equation (6d).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/meeting.wgsl"
#include "contact/proximity/rounds.wgsl"
#include "contact/proximity/separation.wgsl"
#include "contact/proximity/sides.wgsl"
#include "contact/proximity/sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(4) var<storage, read>       velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(5) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(6) var<storage, read>       listed          : array<ListedPair>;
@group(0) @binding(7) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(8) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(9) var<storage, read_write> statistics      : array<atomic<u32>>;
override kGives : bool = false;
var<workgroup> pairs : u32;

fn speeds_along(ids : vec4u, n : vec3f) -> vec4f {
  let at = ids & vec4u(kIdBits);
  return vec4f(dot(n, velocity[at.x].xyz), dot(n, velocity[at.y].xyz), dot(n, velocity[at.z].xyz),
               dot(n, velocity[at.w].xyz));
}

fn count_moved(ids : vec4u, shifts : vec4f) {
  for (var role = 0u; role < 4u; role++) {
    if (shifts[role] != 0.0) { share_mass(ids[role]); }
  }
  atomicMax(&statistics[kStatMeeting], this_round.number);
}

fn give(ids : vec4u, word : u32, units_in_one : f32, amounts : vec4f, n : vec3f) {
  for (var role = 0u; role < 4u; role++) {
    if (amounts[role] == 0.0) { continue; }
    add_units(kVertexWords * (ids[role] & kIdBits) + word, units_in_one, amounts[role] * n);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn separate_pairs(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
                  @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    pairs = select(atomicLoad(&statistics[kStatPairs]), 0u, round_is_idle(kGives));
  }
  let count = workgroupUniformLoad(&pairs);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = listed[pair].ids;
    if (is_crossing(ids) || !is_self_pair(ids)) { continue; }
    let ends = ends_of(ids, listed[pair].words);
    if (!end_too_near(ids, ends)) { continue; }
    if (tangles_of(ids, 0u, 4u) != 0u || (listed[pair].words.w & kOfTwoBodies) != 0u) {  // held back
      if (!kGives) { atomicMax(&statistics[kStatMeeting], kMostSeparations); }
      continue;
    }
    let n = ends.normal;
    let whole = movers_by_whole_mass(ids);
    let shifts = shifts_of(ids, ends.along, ends.gap, whole);
    if (!kGives) {
      count_moved(ids, shifts);
      continue;
    }
    let shares = vec4f(share_count(ids.x), share_count(ids.y), share_count(ids.z), share_count(ids.w));
    // No more than it has counted, of the shared masses.
    let movers = Movers(select(whole.mass / shares, vec4f(0.0), shifts == vec4f(0.0)), whole.stays);
    give(ids, kPushWord, kPushUnits, shifts_of(ids, ends.along, ends.gap, movers) / shares, n);
    let by_speed = starts_along(ids, n) + step.time.dt * speeds_along(ids, n);
    if (sides_apart(ids, by_speed) < ends.gap) {
      give(ids, kChangeWord, kSpeedUnits, shifts_of(ids, by_speed, ends.gap, movers) / (step.time.dt * shares), n);
    }
  }
}
