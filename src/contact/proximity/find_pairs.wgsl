// Narrow phase: lists the feature pairs of the candidates that may come within the thickness before the next search:
// where their distance is less than that, the slacks of both and how far the ways ahead of either side may bring it
// along the line between them (docs/contact.md, Reach). A vertex or edge belongs to one of its triangles, so that each
// pair of features is found once (Curtis et al. 2008, Fast Collision Detection for Deformable Models using
// Representative-Triangles). An edge that passes through a triangle which it does not touch at rest is counted, and
// listed with the direction in which both come apart.
//
// Grid-stride loop over the candidates, kTesters at a time. Of the 15 pairs of features that two triangles may have
// some three are their own. A workgroup collects these and shares them out: invocations that each tested all pairs of
// their own candidate would wait for each other at every one of the 15.
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
#include "contact/proximity/crossing.wgsl"
#include "contact/proximity/pair_tests.wgsl"
#include "contact/proximity/untangle.wgsl"
#include "contact/proximity/allocate.wgsl"
//                                                                                      elements
@group(0) @binding(0) var<uniform>             params          : SearchParams;
@group(0) @binding(1) var<storage, read>       predicted       : array<vec4f>;       // 3 * vertex_count: reach.wgsl
@group(0) @binding(2) var<storage, read>       triangles       : array<vec4u>;       // corners; w: owned, friction
@group(0) @binding(3) var<storage, read>       trees           : array<vec4u>;
@group(0) @binding(4) var<storage, read>       points          : array<vec4f>;       // of colliders: move_points.wgsl
@group(0) @binding(5) var<storage, read>       candidates      : array<vec2u>;
@group(0) @binding(6) var<storage, read_write> listed          : array<ListedPair>;  // pair_capacity
@group(0) @binding(7) var<storage, read_write> vertex_contacts : array<atomic<u32>>; // see state/contact.wgsl
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;

var<workgroup> count : u32;  // of the candidates

// The distance that two features of cloth keep: of one cloth no more than half of what they have at rest; 0: they do
// not meet.
const kTouchingAtRest = 0.02;  // of the thickness
fn rest_of(id : u32) -> vec4u { return trees[params.first_rest + (id & kIdBits)]; }
fn thickness_of(ids : vec4u) -> f32 {
  let a = rest_of(ids.x);
  let b = rest_of(ids.y);
  let c = rest_of(ids.z);
  let d = rest_of(ids.w);
  if (a.w != c.w) { return params.self_thickness; }
  let at = array(bitcast<vec3f>(a.xyz), bitcast<vec3f>(b.xyz), bitcast<vec3f>(c.xyz), bitcast<vec3f>(d.xyz));
  let apart = length(closest_of_pair(is_edge_pair(ids), at[0], at[1], at[2], at[3]).apart);
  if (apart <= kTouchingAtRest * params.self_thickness) { return 0.0; }
  return select(params.self_thickness, 0.5 * apart, apart < 2.0 * params.self_thickness);
}

// Of a candidate's two triangles one whose edges may pass through the other one.
struct Crossing { own : Face, onto : Face }
fn crossing_of(a : Face, b : Face, by_b : bool) -> Crossing {
  if (by_b) { return Crossing(b, a); }
  return Crossing(a, b);
}
fn corner_at(face : Face, k : u32) -> vec3f { return select(select(face.c, face.b, k == 1u), face.a, k == 0u); }

fn edge_crosses(own : Face, k : u32, onto : Face) -> bool {
  let pq = edge_ids(own.ids, k);
  if ((own.owned & (8u << k)) == 0u || any(onto.ids == pq.xxx) || any(onto.ids == pq.yyy)) { return false; }
  let p = corner_at(own, k);
  let q = corner_at(own, (k + 1u) % 3u);
  return crosses(p, q, onto.a, onto.b, onto.c) && !touch_at_rest(pq, onto.ids);
}

// Whether some features of an edge and a triangle of one cloth do not meet, since they touch at rest: nothing keeps
// these apart, so that they cross is no tangle.
fn touch_at_rest(pq : vec2u, ids : vec3u) -> bool {
  if (((pq.x | ids.x) & kColliderPoint) != 0u) { return false; }
  let first = rest_of(pq.x);
  let corner = rest_of(ids.x);
  if (first.w != corner.w) { return false; }
  let p = bitcast<vec3f>(first.xyz);
  let q = bitcast<vec3f>(rest_of(pq.y).xyz);
  let a = bitcast<vec3f>(corner.xyz);
  let b = bitcast<vec3f>(rest_of(ids.y).xyz);
  let c = bitcast<vec3f>(rest_of(ids.z).xyz);
  let least = min(min(length(closest_on_triangle(p, a, b, c).apart), length(closest_on_triangle(q, a, b, c).apart)),
                  min(min(length(closest_on_edges(p, q, a, b).apart), length(closest_on_edges(p, q, b, c).apart)),
                      length(closest_on_edges(p, q, c, a).apart)));
  return least <= kTouchingAtRest * params.self_thickness;
}

// Of a ball, a capsule or a plane: bits 0 to 2 corners (planes) or edges (capsules), 3 and 4 a capsule's ends, 3 a
// ball; 5 to 7 corners (balls, capsules).
fn near_shape(triangle : vec4u, kind : u32, point : u32) -> u32 {
  let p = points[point];
  let far = points[point + select(0u, 2u, kind == kNearCapsule)].xyz;
  let n = points[point + select(0u, 1u, kind == kNearPlane)].xyz;
  let radius = params.thickness + p.w + scripted;
  var corners = array(corner_of(triangle.x), corner_of(triangle.y), corner_of(triangle.z));
  var ends = array(Corner(p.xyz, 0.0, vec3f(0.0)), Corner(far, 0.0, vec3f(0.0)));
  var hits = 0u;
  for (var k = 0u; k < 3u; k++) {
    if (kind == kNearPlane) { hits |= bit(k, (triangle.w & (1u << k)) != 0u && plane_near(corners[k], p.xyz, n)); }
    if (kind == kNearCapsule && (triangle.w & (8u << k)) != 0u) {
      hits |= bit(k, edges_near(corners[k], corners[(k + 1u) % 3u], ends[0], ends[1], radius));
    }
  }
  if (kind == kNearPlane) { return hits; }
  let last = select(0u, 1u, kind == kNearCapsule);
  for (var k = 0u; k < 3u; k++) {
    let owned = (triangle.w & (1u << k)) != 0u;
    hits |= bit(5u + k, owned && edges_near(corners[k], corners[k], ends[0], ends[last], radius));
  }
  for (var end = 0u; end < select(1u, 2u, kind == kNearCapsule); end++) {
    hits |= bit(3u + end, corner_near(ends[end], corners[0], corners[1], corners[2], radius));
  }
  return hits;
}
fn plane_near(corner : Corner, q : vec3f, n : vec3f) -> bool {
  return dot(n, corner.at - q) < params.thickness + scripted + corner.slack + way_against(n, corner);
}

fn pair_of_shape(a : vec3u, kind : u32, point : u32, hit : u32) -> vec4u {
  let id = kColliderPoint | point;
  if (kind == kNearPlane) { return vec4u(corner_id(a, hit), id | kPairFlag, 0u, 0u); }
  if (hit >= 5u) {
    return vec4u(corner_id(a, hit - 5u), id | kPairFlag, select(0u, id + 2u, kind == kNearCapsule), 0u);
  }
  if (hit >= 3u) { return vec4u(id + 2u * (hit - 3u), a); }
  return vec4u(edge_ids(a, hit), id, id + 2u) | vec4u(kPairFlag, 0u, 0u, 0u);
}

fn rim_of(id : u32) -> f32 {
  let place = select(id, params.vertex_count + (id & kIdBits), (id & kColliderPoint) != 0u);
  return bitcast<f32>(trees[params.first_rim + place / 4u][place % 4u]);
}
fn rims_of(ids : vec3u) -> vec3f { return vec3f(rim_of(ids.x), rim_of(ids.y), rim_of(ids.z)); }

fn kind_of(id : u32) -> u32 {
  if ((id & kColliderPoint) == 0u) { return kFromCloth; }
  return select(kFromOpenMesh, kFromClosedMesh, points[id & kIdBits].w < 0.0);
}

// Lists that edge `k` of `own`, a cloth triangle of this number or one of a collider, passes through `onto`; by its
// first or its second end.
fn list_crossing(own : Face, number : u32, k : u32, onto : Face, second : bool, pair : u32) {
  let pq = edge_ids(own.ids, k);
  let p = corner_at(own, k);
  let q = corner_at(own, (k + 1u) % 3u);
  let tip = corner_at(own, (k + 2u) % 3u);
  let e = unit(q - p);
  let at = crossing_place(p, q, onto.a, onto.b, onto.c);
  let weights = vec3f(1.0 - at.x - at.y, at);
  let through = weights.x * onto.a + weights.y * onto.b + weights.z * onto.c;
  let s = place_on_segment(through, p, q - p);
  let edge_at = select(select(vec3f(s, 0.0, 1.0 - s), vec3f(0.0, 1.0 - s, s), k == 1u),
                       vec3f(1.0 - s, s, 0.0), k == 0u);
  let edge = sheet_of(own.a, own.b, own.c, rims_of(own.ids), edge_at, kind_of(pq.x));
  let face = sheet_of(onto.a, onto.b, onto.c, rims_of(onto.ids), weights, kind_of(onto.ids.x));
  var turn = vec3f(0.0);
  if (edge.kind == kFromCloth) {
    turn = contour_from_edge(p, e, tip, face.normal);
    let opposite = trees[params.first_opposite + number][k];
    if (opposite != kNoCorner) {
      turn += contour_from_edge(p, e, predicted[params.vertex_count + opposite].xyz, face.normal);
    }
  }
  let way = untangling(edge, e, turn, face);
  listed[pair].ids = vec4u(select(pq.x, pq.y, second), onto.ids.x, onto.ids.y | kCrossingFlag, onto.ids.z);
  listed[pair].words = vec4u(select(pq.y, pq.x, second) & kIdBits, bitcast<vec3u>(way));
  let mark = select(kTangledMesh, kTangledCloth, edge.kind == kFromCloth && face.kind == kFromCloth);
  mark_tangled(pq.x, mark);
  mark_tangled(pq.y, mark);
  for (var corner = 0u; corner < 3u; corner++) { mark_tangled(corner_id(onto.ids, corner), mark); }
}
fn mark_tangled(id : u32, mark : u32) {
  if ((id & kColliderPoint) == 0u) { atomicOr(&vertex_contacts[kVertexWords * id + kTangledWord], mark); }
}

// Crossings as bits of a candidate: 15 to 17 the edges of a through b, 18 to 20 of b through a, each by its first
// end; six further by its second. An edge of a collider is listed once: the collider does not feel it.
const kFirstCrossing = 15u;
const kByOtherEnd = 6u;

// The edges of a candidate's triangles that pass through the other one, as bits from kFirstCrossing on.
fn crossings_of(candidate : vec2u, own : vec4u, other : vec4u) -> u32 {
  let a = face_of(own);
  let b = face_of(other);
  if (!overlap(box_of(a.a, a.b, a.c), box_of(b.a, b.b, b.c))) { return 0u; }
  var found = 0u;
  for (var edge = 0u; edge < 6u; edge++) {
    let crossing = crossing_of(a, b, edge >= 3u);
    found |= bit(edge, edge_crosses(crossing.own, edge % 3u, crossing.onto));
  }
  if (found == 0u) { return 0u; }
  atomicAdd(&statistics[kStatCrossingsLeft], countOneBits(found));
  let twice = select(found & 7u, found, candidate.x >> kKindShift == kNearCloth);
  return (found | (twice << kByOtherEnd)) << kFirstCrossing;
}

// Equation (1b) of docs/contact.md: kComesOnFront, or 0.
const kHasInside = 0x80000000u;  // of a cloth's number: a body, or cloth about a gas
const kIsJoined = 0x40000000u;   // a body that a solver's matrix has together with others
fn are_of_one_system(a : u32, b : u32) -> bool { return a == b || (a & b & kIsJoined) != 0u; }
fn way_out(candidate : vec2u, ids : vec4u) -> u32 {
  if (is_edge_pair(ids)) { return 0u; }
  let a = face_of(own_triangle(candidate));
  let b = face_of(other_triangle(candidate));
  let opposite = dot(cross(a.b - a.a, a.c - a.a), cross(b.b - b.a, b.c - b.a)) < 0.0;
  var on_front = opposite;
  if (candidate.x >> kKindShift != kNearCloth) {
    on_front = !is_collider(ids.x) || opposite;
  } else {
    let vertex = rest_of(ids.x).w;
    let face = rest_of(ids.y).w;
    let face_inside = (face & kHasInside) != 0u;
    let of_two_kinds = face_inside != ((vertex & kHasInside) != 0u);
    if (of_two_kinds) {
      on_front = face_inside || opposite;
    } else if (opposite) {
      on_front = vertex != face;
    } else {
      on_front = ids.x > ids.y;
    }
  }
  return select(0u, kComesOnFront, on_front);
}

fn friction_of_cloth(triangle : u32) -> f32 { return f32(triangles[triangle].w >> 8u) * kFrictionUnit; }

fn list_features(pair : u32, candidate : vec2u, ids : vec4u) {
  var thickness = params.thickness;
  var sides = 0u;
  let kind = candidate.x >> kKindShift;
  if (kind == kNearCloth) {
    thickness = thickness_of(ids);
    let a = rest_of(ids.x).w;
    let b = rest_of(ids.z).w;
    if (are_of_one_system(a, b)) {
      sides = kOfOneSystem | select(0u, kOfBodies, (a & b & kIsJoined) != 0u) | select(0u, kOfTwoBodies, a != b);
    }
  }
  if (kind <= kNearDeforming) { sides |= way_out(candidate, ids); }
  var friction = friction_of_cloth(candidate.x & kPlaceBits);
  if (kind == kNearCloth) {
    let other = friction_of_cloth(candidate.y);
    friction = select(sqrt(friction * other), friction, friction == other);
  }
  listed[pair] = ListedPair(ids, vec4u(bitcast<u32>(thickness), bitcast<u32>(friction), 0u, sides));
}

// Lists what an invocation has found: of its own candidate pairs with a shape and crossings; then the tests that it has
// made and that have found a pair.
fn list_found(thread : u32, candidate : vec2u, of_own : u32, tested : u32, first : u32) {
  var own_left = of_own;
  var tests_left = tested;
  for (var pair = first; (own_left | tests_left) != 0u && pair < params.pair_capacity; pair++) {
    let hit = firstTrailingBit(own_left);
    if (own_left != 0u && hit >= kFirstCrossing) {
      own_left &= own_left - 1u;
      let edge = (hit - kFirstCrossing) % kByOtherEnd;
      let by_other = edge >= 3u;
      let crossing = crossing_of(face_of(own_triangle(candidate)), face_of(other_triangle(candidate)), by_other);
      list_crossing(crossing.own, select(candidate.x & kPlaceBits, candidate.y, by_other), edge % 3u, crossing.onto,
                    hit >= kFirstCrossing + kByOtherEnd, pair);
      continue;
    }
    var source = candidate;
    var ids : vec4u;
    if (own_left != 0u) {
      own_left &= own_left - 1u;
      ids = pair_of_shape(own_triangle(source).xyz, source.x >> kKindShift, source.y, hit);
    } else {
      let test = test_at(firstTrailingBit(tests_left) * kTesters + thread);
      tests_left &= tests_left - 1u;
      source = taken[test >> 4u];
      ids = pair_of_faces(own_triangle(source).xyz, other_triangle(source).xyz, test & 15u);
    }
    list_features(pair, source, ids);
  }
}

@compute @workgroup_size(kTesters)
fn find_pairs(@builtin(workgroup_id) group : vec3u, @builtin(num_workgroups) groups : vec3u,
              @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    let works = atomicLoad(&statistics[kStatDue]) != 0u && atomicLoad(&statistics[kStatRolledBack]) == 0u;
    count = select(0u, atomicLoad(&statistics[kStatCandidates]), works);
    scripted = bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  }
  let end = workgroupUniformLoad(&count);
  for (var first = group.x * kTesters; first < end; first += groups.x * kTesters) {
    if (thread == 0u) {
      atomicStore(&corner_tests, 0u);
      atomicStore(&edge_tests, 0u);
    }
    workgroupBarrier();
    var candidate = vec2u(0u);
    var of_own = 0u;
    if (first + thread < end) {
      candidate = candidates[first + thread];
      taken[thread] = candidate;
      let kind = candidate.x >> kKindShift;
      let own = own_triangle(candidate);
      if (kind >= kNearSphere) {
        of_own = near_shape(own, kind, candidate.y);
      } else {
        let other = other_triangle(candidate);
        hand_out(thread, owned_tests(own, other));
        of_own = crossings_of(candidate, own, other);
      }
    }
    workgroupBarrier();
    if (thread == 0u) { test_counts = vec2u(atomicLoad(&corner_tests), atomicLoad(&edge_tests)); }
    let counts = workgroupUniformLoad(&test_counts);
    var found = 0u;
    for (var k = 0u; k * kTesters + thread < counts.x + counts.y; k++) {
      found |= bit(k, is_near(test_at(k * kTesters + thread)));
    }
    let wanted = countOneBits(of_own) + countOneBits(found);
    let pair = allocate(thread, wanted, kStatPairs);
    if (wanted > 0u && pair + wanted > params.pair_capacity) { atomicStore(&statistics[kStatRolledBack], 1u); }
    list_found(thread, candidate, of_own, found, pair);
    workgroupBarrier();
  }
}
