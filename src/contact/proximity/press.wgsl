// Finds the vertices that come against an obstacle in the substep about to be solved, and how. They take it in backward
// Euler: with a history, the force that stops one would be 2.25 times what it had to lose, and friction as much too
// strong. Grid-stride loop over the pairs. Source: docs/solvers/multigrid.md, Contact.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/relative_velocity.wgsl"
#include "contact/proximity/cones.wgsl"
#include "contact/proximity/curved.wgsl"
#include "contact/proximity/history.wgsl"
#include "contact/proximity/hold_rule.wgsl"
#include "contact/proximity/press_sums.wgsl"
//                                                                                  elements      unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       previous   : array<vec4f>;        // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read_write> velocity   : array<atomic<u32>>;  // 4 * vertex_count  m/s, bits of f32
@group(0) @binding(3) var<storage, read>       points     : array<vec4f>;        // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read>       listed     : array<ListedPair>;
@group(0) @binding(5) var<storage, read>       statistics : array<u32>;
@group(0) @binding(6) var<storage, read_write> presses    : array<atomic<i32>>;  // press_sums.wgsl
@group(0) @binding(7) var<storage, read>       rings      : array<u32>;          // feature_rings.hpp

override kOwnPairs : bool = false;  // only those press a vertex (contact/rules/solved_contact.hpp)
const kRoundCosine = 0.8;  // from which on a round obstacle presses along the pair's direction alone
const kRoundFade = 0.1;  // how much more of it until that is along the vertex's own

// How a vertex is pressed: in this direction, along which its way is so long.
struct Outward {
  direction : vec3f,
  way : f32,          // over the obstacle, m
}

// From a segment to a place, m.
fn arm_of(a : vec3f, b : vec3f, place : vec3f) -> vec3f {
  return place - a - place_on_segment(place, a, b - a) * (b - a);
}

// The pair's own direction, and where both do not differ too much that which the vertex will have.
fn mixed(pairs_own : Outward, direction : vec3f, way : f32) -> Outward {
  let part = saturate((dot(direction, pairs_own.direction) - kRoundCosine) / kRoundFade);
  let sum = pairs_own.direction + part * (direction - pairs_own.direction);
  return Outward(sum / length(sum), pairs_own.way + part * (way - pairs_own.way));
}

// A round obstacle presses a vertex away from its axis, in the direction that the vertex will have: equation (11b).
fn turned(pairs_own : Outward, ids : vec4u, place : vec3f, moved : vec3f) -> Outward {
  let first = collider_of(ids);  // the ends of its axis
  let second = select(first, ids.w, is_edge_pair(ids));
  let before = arm_of(start_of(first).xyz, start_of(second).xyz, place);
  let arm = arm_of(end_of(first).xyz, end_of(second).xyz, place + moved);
  let size = length(arm);
  if (size <= 0.0) { return pairs_own; }
  return mixed(pairs_own, arm / size, size - length(before));
}

fn add(word : u32, value : f32) {
  let units = i32(round(value));
  let before = atomicAdd(&presses[word], units);
  let after = before + units;  // passes over the end of i32 as the atomic sum does
  let wraps = select(0, 1, units > 0 && after < before) - select(0, 1, units < 0 && after > before);
  if (wraps != 0) { atomicAdd(&presses[word + kPressWraps], wraps); }
}

// Whether a pair presses a vertex that has this weight in it. A bound has no weight: what presses beside the vertex
// would hold it up as if it were under it, and a body would stand that is past a rim by less than an edge. Round
// obstacles have pairs with triangles and edges alone.
fn presses_vertex(weight : f32, radius : f32) -> bool {
  return select(weight != 0.0, abs(weight) >= kWholeWeight, kOwnPairs && radius == 0.0);
}

@compute @workgroup_size(kWorkgroupSize)
fn press(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let count = select(statistics[kStatPairs], 0u, statistics[kStatRolledBack] != 0u);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = listed[pair].ids;
    if (is_self_pair(ids) || is_crossing(ids)) { continue; }
    let measured = measure(ids, listed[pair].words.w);
    if (!measured.counts) { continue; }
    // Edges over a capsule press both their vertices, each along its own direction.
    if (is_shape_pair(ids) && is_collider(ids.z)) { continue; }
    let weights = weights_of(ids, measured.s, measured.t);
    let r = relative_velocity(ids, weights, measured);
    let way = step.time.dt * dot(measured.normal, r.velocity + r.surface);
    if (!(measured.gap + min(way, 0.0) < kContactTouching * step.contact.thickness)) { continue; }
    if (!lies_in_cones(ids, measured)) { continue; }
    let missing = step.contact.thickness - measured.gap;
    let room = min(missing, kHoldPart * missing);
    let friction = min(friction_of(ids, bitcast<f32>(listed[pair].words.y)), kMostFriction);
    let curved = surface_at(ids, weights, measured.normal);
    var touching = vec3f(0.0);
    for (var role = 0u; role < role_count(ids); role++) {
      if (!is_collider(ids[role])) { touching += abs(weights[role]) * start_of(ids[role]).xyz; }
    }
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role]) || !presses_vertex(weights[role], measured.radius)) { continue; }
      let side = sign(weights[role]);
      let vertex = ids[role] & kIdBits;
      // A vertex's own way, not the pair's: neighbours that differ in speed would be made to go on differing.
      let moved = step.time.dt * velocity_of(vertex);
      var outward = Outward(side * measured.normal, dot(measured.normal, side * moved + step.time.dt * r.surface));
      let place = start_of(ids[role]).xyz;
      if (measured.radius > 0.0) { outward = turned(outward, ids, place, moved); }
      if (!is_flat(curved)) {
        let before = place - touching;
        let after = before + moved + side * step.time.dt * r.surface;
        let turn = turned_by(curved, outward.direction, measured.gap, before, after);
        outward = mixed(outward, turn.direction, outward.way + turn.more);
      }
      let lack = clamp((room - outward.way) / step.contact.thickness, -kMostLack, kMostLack);
      let weight = abs(weights[role]) * kPressUnits;
      let normal = weight * outward.direction;
      let surface = weight * clamp(-side * r.surface, vec3f(-kMostSurface), vec3f(kMostSurface));
      var sums : array<f32, kPressWraps>;
      for (var k = 0u; k < 3u; k++) {
        sums[kPressNormal + k] = normal[k];
        sums[kPressSurface + k] = surface[k];
      }
      sums[kPressLack] = abs(weights[role]) * kLackUnits * lack;
      sums[kPressRestored] = abs(weights[role]) * kLackUnits * max(room, 0.0) / step.contact.thickness;
      sums[kPressWeight] = weight;
      sums[kPressFriction] = weight * friction;
      // A loop: SwiftShader needs minutes and gigabytes to compile nine calls.
      for (var k = 0u; k < kPressWraps; k++) { add(press_words(vertex) + k, sums[k]); }
      forget_history(vertex);
    }
  }
}
