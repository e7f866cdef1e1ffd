// Finds the pairs of cloth whose sides may meet on the ways that their vertices go, and marks the vertices; and how far
// each vertex may go before the planes half way between it and all that it is listed with: equation (6) of
// docs/contact.md. The same before obstacles of pairs without record, for vertices that go far. Further rounds ask the
// pairs of cloth again of which a vertex was not held back in those before: ways were shortened since, also for edges
// (shorten_ways.wgsl). Grid-stride loop over the pairs.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/meeting.wgsl"
#include "contact/proximity/rounds.wgsl"
#include "contact/proximity/slow.wgsl"
#include "contact/proximity/turned_plane.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             this_round      : Round;
@group(0) @binding(1) var<uniform>             step            : StepBlock;
@group(0) @binding(2) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(4) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(5) var<storage, read>       listed          : array<ListedPair>;
@group(0) @binding(6) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(7) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;

var<workgroup> pairs : u32;

fn end_of_way(vertex : u32) -> vec3f { return position[vertex].xyz; }

fn end_before(vertex : u32, part : f32) {
  if (part < 1.0) { atomicMax(&vertex_contacts[kVertexWords * vertex + kPartWord], ~bitcast<u32>(part)); }
}

fn goes_far(vertex : u32) -> bool {
  return (atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kFarWay) != 0u;
}

// Of a pair with a collider, whose record would hold nothing but for vertices that go far.
fn end_before_collider(ids : vec4u, words : vec4u) {
  let thickness = bitcast<f32>(words.x);
  let side = solid_side_of(ids, select(2u, 1u, is_collider(ids.x)));
  var is_far = false;
  for (var role = side.cloth_first; role < side.cloth_last; role++) {
    is_far = is_far || goes_far(ids[role] & kIdBits);
  }
  if (!is_far) { return; }
  let measured = measure(ids, words.w);
  let n = turned_normal(ids, measured, thickness);
  let reach = reach_of(ids, side.first, side.last, side.toward, n, measured.radius);
  for (var role = side.cloth_first; role < side.cloth_last; role++) {
    let vertex = ids[role] & kIdBits;
    let then = beyond_solid(side.toward, dot(n, position[vertex].xyz), reach, measured.gap, thickness);
    if (then <= 0.0 || position[vertex].w == 0.0) { continue; }
    let now = beyond_solid(side.toward, dot(n, previous[vertex].xyz), reach, measured.gap, thickness);
    end_before(vertex, part_before(now, then));
    atomicOr(&vertex_contacts[kVertexWords * vertex + kHeldWord], kMarked);
    atomicMax(&statistics[kStatMeeting], this_round.number);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn find_meeting(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
                @builtin(local_invocation_index) thread : u32) {
  let is_first = this_round.is_first != 0u;
  if (thread == 0u) {
    let last = atomicLoad(&statistics[kStatMeeting]);
    let far = is_first && atomicLoad(&statistics[kStatFarWays]) != 0u;
    let idle = atomicLoad(&statistics[kStatRolledBack]) != 0u || (last < this_round.since && !far);
    pairs = select(atomicLoad(&statistics[kStatPairs]), 0u, idle);
  }
  let count = workgroupUniformLoad(&pairs);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = listed[pair].ids;
    if (is_crossing(ids)) { continue; }
    let words = listed[pair].words;
    if (!is_self_pair(ids)) {
      if (is_first && (words.x & kHasRecord) == 0u) { end_before_collider(ids, words); }
      continue;
    }
    let ends = ends_of(ids, words);
    if (!ends.may_meet) { continue; }
    var all_held = true;
    for (var role = 0u; role < 4u; role++) {
      let vertex = ids[role] & kIdBits;
      let held = atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kHeld;
      if (held == 0u && previous[vertex].w != 0.0) {
        all_held = false;
        let side = select(-1.0, 1.0, role < roles_of_a(ids));
        let then = beyond_half(side, ends.along[role], ends.middle, ends.gap, ends.thickness);
        if (then > 0.0) {
          let start = dot(ends.normal, before_of(ids[role]) - before_of(ids.x));
          end_before(vertex, part_before(beyond_half(side, start, ends.middle, ends.gap, ends.thickness), then));
        }
      }
    }
    if (!end_too_near(ids, ends) || all_held) { continue; }
    if (this_round.is_last != 0u) {
      // No nearer than half a margin: where each substep halves a gap, f32 soon knows nothing of it.
      let half = 0.5 * max(ends.gap, margin_of(ends.gap, ends.thickness));
      let least = min(half, least_apart(ends.gap, ends.thickness));
      slow_all(part_until(ends.gap, ends.apart, least));
    }
    atomicMax(&statistics[kStatMeeting], this_round.number);
    if ((words.w & kOfTwoBodies) != 0u) { continue; }  // for these the substep ends before its time
    for (var role = 0u; role < 4u; role++) {
      atomicOr(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kHeldWord], kMarked);
    }
  }
}
