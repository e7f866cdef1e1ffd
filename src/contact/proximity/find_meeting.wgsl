// Finds the pairs of cloth whose sides may meet on the ways that their vertices go, and marks the vertices; and how far
// each vertex may go before the planes half way between it and all that it is listed with: equation (6) of
// docs/contact.md. The same before obstacles of pairs without record, for vertices that go far. Grid-stride loop over
// the pairs. Further rounds ask the pairs of cloth again of which a vertex was not held back in those before.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/planes.wgsl"
#include "contact/proximity/solid_reach.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(3) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read>       listed          : array<ListedPair>;
@group(0) @binding(5) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(6) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
override kRound : u32 = 1;
override kSelf : u32 = 1;  // 0: no cloth meets cloth
const kShortWay = 0.499;  // of the gap: less than half, by more than the rounding of either side's place

var<workgroup> pairs : u32;

fn end_of_way(vertex : u32) -> vec3f { return position[vertex].xyz; }

// What is between the two sides at the start of the substep, m: the gap, and the distance that they keep. 0: nothing
// that must stay.
fn gap_of(words : vec4u) -> vec2f {
  if ((words.x & kHasRecord) == 0u) { return bitcast<vec2f>(words.zx) * select(1.0, 0.0, words.x == 0u); }
  let number = words.x & ~kHasRecord;
  return vec2f(select(contacts[number].normal.w, 0.0, contacts[number].solid != 0u), contacts[number].thickness);
}
// The direction from B to A, and where side A lies along it, m.
fn line_of(ids : vec4u, words : vec4u) -> vec4f {
  if ((words.x & kHasRecord) == 0u) {
    let measured = measure(ids);
    return vec4f(measured.normal, measured.place_a);
  }
  let number = words.x & ~kHasRecord;
  return vec4f(contacts[number].normal.xyz, contacts[number].place.z);
}

// The longest way of the four vertices, m.
fn longest_way(ids : vec4u) -> f32 {
  var longest = 0.0;
  for (var role = 0u; role < 4u; role++) {
    let vertex = ids[role] & kIdBits;
    longest = max(longest, distance(previous[vertex].xyz, position[vertex].xyz));
  }
  return longest;
}

// How much of a way takes a vertex past no plane, by how far it is beyond it at the start and would be at the end.
fn part_before(now : f32, then : f32) -> f32 {
  if (then <= 0.0) { return 1.0; }
  if (now < 0.0) { return now / (now - then); }
  return select(1.0, 0.0, then > now);
}

fn end_before(vertex : u32, part : f32) {
  if (part < 1.0) { atomicMax(&vertex_contacts[kVertexWords * vertex + kPartWord], ~bitcast<u32>(part)); }
}

fn goes_far(vertex : u32) -> bool {
  return (atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kFarWay) != 0u;
}

// Of a pair with a collider, whose record would hold nothing but for vertices that go far.
fn end_before_collider(ids : vec4u, thickness : f32) {
  let on_b = is_collider(ids.x);  // where the cloth is
  let middle = roles_of_a(ids);
  let first = select(0u, middle, on_b);
  let end = select(middle, role_count(ids), on_b);
  var is_far = false;
  for (var role = first; role < end; role++) { is_far = is_far || goes_far(ids[role] & kIdBits); }
  if (!is_far) { return; }
  let measured = measure(ids);
  let side = select(1.0, -1.0, on_b);
  let n = measured.normal;
  let reach = reach_of(ids, select(middle, 0u, on_b), select(role_count(ids), middle, on_b), side, n, measured.radius);
  for (var role = first; role < end; role++) {
    let vertex = ids[role] & kIdBits;
    let then = beyond_solid(side, dot(n, position[vertex].xyz), reach, measured.gap, thickness);
    if (then <= 0.0 || position[vertex].w == 0.0) { continue; }
    let now = beyond_solid(side, dot(n, previous[vertex].xyz), reach, measured.gap, thickness);
    end_before(vertex, part_before(now, then));
    atomicOr(&vertex_contacts[kVertexWords * vertex + kHeldWord], kMarked);
    atomicMax(&statistics[kStatMeeting], kRound);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn find_meeting(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
                @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    let idle = atomicLoad(&statistics[kStatRolledBack]) != 0u ||
               atomicLoad(&statistics[kStatMeeting]) + 1u < kRound ||
               (kSelf == 0u && atomicLoad(&statistics[kStatFarWays]) == 0u);
    pairs = select(atomicLoad(&statistics[kStatPairs]), 0u, idle);
  }
  let count = workgroupUniformLoad(&pairs);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = listed[pair].ids;
    if (is_crossing(ids)) { continue; }
    let words = listed[pair].words;
    if (!is_self_pair(ids)) {
      if (kRound == 1u && (words.x & kHasRecord) == 0u) { end_before_collider(ids, bitcast<f32>(words.x)); }
      continue;
    }
    let between = gap_of(words);
    let gap = between.x;
    let thickness = between.y;
    if (gap <= 0.0 || longest_way(ids) < kShortWay * gap - margin_of(gap, thickness)) { continue; }
    let line = line_of(ids, words);
    var least = 3e38;   // of side A along the normal, m
    var most = -3e38;   // of side B
    var all_held = true;
    for (var role = 0u; role < 4u; role++) {
      let vertex = ids[role] & kIdBits;
      let place = position[vertex];
      let along = dot(line.xyz, place.xyz);
      let on_a = role < roles_of_a(ids);
      if (on_a) { least = min(least, along); } else { most = max(most, along); }
      if (kRound > 1u) {
        let held = atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kHeld;
        all_held = all_held && (held != 0u || place.w == 0.0);
      } else if (place.w != 0.0) {
        let side = select(-1.0, 1.0, on_a);
        let then = beyond_half(side, along, line.w, gap, thickness);
        if (then > 0.0) {
          let start = dot(line.xyz, previous[vertex].xyz);
          end_before(vertex, part_before(beyond_half(side, start, line.w, gap, thickness), then));
        }
      }
    }
    if (least - most >= gap || (kRound > 1u && all_held)) { continue; }
    if (least - most >= least_apart(gap, thickness)) { continue; }
    for (var role = 0u; role < 4u; role++) {
      atomicOr(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kHeldWord], kMarked);
    }
    atomicMax(&statistics[kStatMeeting], kRound);
  }
}
