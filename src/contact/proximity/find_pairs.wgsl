// Narrow phase: lists the feature pairs of the candidates that may come within the thickness before the next search:
// where their distance is less than that, the slacks of both and how far the ways ahead of either side may bring it
// along the line between them (docs/contact.md, Reach). Grid-stride loop over the candidates. A vertex or edge belongs
// to one of its triangles, so that each pair of features is found once (Curtis et al. 2008, Fast Collision Detection
// for Deformable Models using Representative-Triangles). An edge that passes through a triangle which it does not
// touch at rest is counted, and listed with the direction in which both come apart.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
#include "contact/proximity/closest.wgsl"
#include "contact/proximity/crossing.wgsl"
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

// A triangle and the features that it owns: bits 0 to 2 its corners, 3 to 5 the edges from them.
struct Face {
  a : vec3f, b : vec3f, c : vec3f,  // m
  reach : vec3f,  // slack of each corner, m
  ahead_a : vec3f, ahead_b : vec3f, ahead_c : vec3f,  // ways ahead, m
  ids : vec3u,
  owned : u32,
}

var<workgroup> count : u32;

fn cloth_face(t : u32) -> Face {
  let corner = triangles[t];
  let a = predicted[params.vertex_count + corner.x];
  let b = predicted[params.vertex_count + corner.y];
  let c = predicted[params.vertex_count + corner.z];
  return Face(a.xyz, b.xyz, c.xyz, vec3f(a.w, b.w, c.w), predicted[2u * params.vertex_count + corner.x].xyz,
              predicted[2u * params.vertex_count + corner.y].xyz, predicted[2u * params.vertex_count + corner.z].xyz,
              corner.xyz, corner.w & 63u);
}

// The other side of a candidate that is a triangle.
fn other_face(candidate : vec2u) -> Face {
  let kind = candidate.x >> kKindShift;
  if (kind == kNearCloth) { return cloth_face(candidate.y); }
  var ids : vec3u;
  var owned : u32;
  if (kind == kNearDeforming) {
    let corner = triangles[candidate.y];
    ids = corner.xyz;
    owned = corner.w & 63u;
  } else {
    let w = vec3u(trees[candidate.y].w, trees[candidate.y + 1u].w, trees[candidate.y + 2u].w);
    ids = w & vec3u(kIdBits);
    let corners = ((w >> vec3u(30u)) & vec3u(1u)) << vec3u(0u, 1u, 2u);  // bit 30: owns the corner; 31: its edge
    let edges = (w >> vec3u(31u)) << vec3u(3u, 4u, 5u);
    owned = corners.x | corners.y | corners.z | edges.x | edges.y | edges.z;
  }
  let reach = vec3f(bitcast<f32>(atomicLoad(&statistics[kStatReach])));
  return Face(points[ids.x].xyz, points[ids.y].xyz, points[ids.z].xyz, reach, vec3f(0.0), vec3f(0.0), vec3f(0.0),
              ids | vec3u(kColliderPoint), owned);
}

// Whether features that are `apart`, from B to A, may come nearer than the radius; on each side one vertex may go its
// way ahead while the other side stops, so only what brings that side nearer counts.
fn may_come(apart : vec3f, radius : f32, ahead_a : array<vec3f, 3>, ahead_b : array<vec3f, 3>) -> bool {
  let distance = length(apart);
  if (distance <= 0.0) { return true; }
  let n = apart / distance;
  let of_a = max(max(-dot(n, ahead_a[0]), -dot(n, ahead_a[1])), -dot(n, ahead_a[2]));
  let of_b = max(max(dot(n, ahead_b[0]), dot(n, ahead_b[1])), dot(n, ahead_b[2]));
  return distance < radius + max(0.0, of_a) + max(0.0, of_b);
}
fn corner_near(p : vec3f, ahead : vec3f, reach : f32, id : u32, face : Face, thickness : f32) -> bool {
  if (any(face.ids == vec3u(id))) { return false; }
  let near = closest_on_triangle(p, face.a, face.b, face.c);
  return may_come(near.apart, thickness + reach + largest(face.reach), array(ahead, ahead, ahead),
                  array(face.ahead_a, face.ahead_b, face.ahead_c));
}

// An edge with its ends, m, their ways ahead, m, and their numbers; how far either end may go beside its way, m.
struct Edge {
  p : vec3f, q : vec3f,
  ahead_p : vec3f, ahead_q : vec3f,
  ids : vec2u,
  reach : f32,
}
fn edge_of(face : Face, k : u32) -> Edge {
  if (k == 0u) {
    return Edge(face.a, face.b, face.ahead_a, face.ahead_b, face.ids.xy, max(face.reach.x, face.reach.y));
  }
  if (k == 1u) {
    return Edge(face.b, face.c, face.ahead_b, face.ahead_c, face.ids.yz, max(face.reach.y, face.reach.z));
  }
  return Edge(face.c, face.a, face.ahead_c, face.ahead_a, face.ids.zx, max(face.reach.z, face.reach.x));
}
fn edges_near(a : Edge, b : Edge, radius : f32) -> bool {
  if (any(a.ids == b.ids) || any(a.ids == b.ids.yx)) { return false; }
  let near = closest_on_edges(a.p, a.q, b.p, b.q);
  return may_come(near.apart, radius + a.reach + b.reach, array(a.ahead_p, a.ahead_q, a.ahead_q),
                  array(b.ahead_p, b.ahead_q, b.ahead_q));
}

fn bit(k : u32, near : bool) -> u32 { return select(0u, 1u << k, near); }

// Which features are near, as bits: 0 to 2 corners of a, 3 to 5 corners of b, 6 + 3 k + l edge k of a and edge l of b.
fn near_features(a : Face, b : Face, thickness : f32) -> u32 {
  var hits = 0u;
  if ((a.owned & 1u) != 0u) { hits |= bit(0u, corner_near(a.a, a.ahead_a, a.reach.x, a.ids.x, b, thickness)); }
  if ((a.owned & 2u) != 0u) { hits |= bit(1u, corner_near(a.b, a.ahead_b, a.reach.y, a.ids.y, b, thickness)); }
  if ((a.owned & 4u) != 0u) { hits |= bit(2u, corner_near(a.c, a.ahead_c, a.reach.z, a.ids.z, b, thickness)); }
  if ((b.owned & 1u) != 0u) { hits |= bit(3u, corner_near(b.a, b.ahead_a, b.reach.x, b.ids.x, a, thickness)); }
  if ((b.owned & 2u) != 0u) { hits |= bit(4u, corner_near(b.b, b.ahead_b, b.reach.y, b.ids.y, a, thickness)); }
  if ((b.owned & 4u) != 0u) { hits |= bit(5u, corner_near(b.c, b.ahead_c, b.reach.z, b.ids.z, a, thickness)); }
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (8u << k)) == 0u) { continue; }
    let edge = edge_of(a, k);
    for (var l = 0u; l < 3u; l++) {
      if ((b.owned & (8u << l)) != 0u) { hits |= bit(6u + 3u * k + l, edges_near(edge, edge_of(b, l), thickness)); }
    }
  }
  return hits;
}

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
  var near : Closest;
  if (is_edge_pair(ids)) {
    near = closest_on_edges(at[0], at[1], at[2], at[3]);
  } else {
    near = closest_on_triangle(at[0], at[1], at[2], at[3]);
  }
  let apart = length(near.apart);
  if (apart <= kTouchingAtRest * params.self_thickness) { return 0.0; }
  return select(params.self_thickness, 0.5 * apart, apart < 2.0 * params.self_thickness);
}

// The edges of `a`, each found by its owner, that pass through `b`, as bits.
fn crossing_edges(a : Face, b : Face) -> u32 {
  return bit(0u, edge_crosses(a.a, a.b, a.ids.xy, a.owned & 8u, b)) |
         bit(1u, edge_crosses(a.b, a.c, a.ids.yz, a.owned & 16u, b)) |
         bit(2u, edge_crosses(a.c, a.a, a.ids.zx, a.owned & 32u, b));
}
fn edge_crosses(p : vec3f, q : vec3f, pq : vec2u, owned : u32, b : Face) -> bool {
  if (owned == 0u || any(b.ids == pq.xxx) || any(b.ids == pq.yyy)) { return false; }
  return crosses(p, q, b.a, b.b, b.c) && !touch_at_rest(pq, b.ids);
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

// Of a ball, a capsule or a plane: bits 0 to 2 corners (planes) or edges (capsules), 3 and 4 a capsule's
// ends, 3 a ball.
fn near_shape(a : Face, kind : u32, point : u32) -> u32 {
  let p = points[point];
  let scripted = bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  if (kind == kNearPlane) {
    let n = points[point + 1u].xyz;
    let reach = a.reach + vec3f(params.thickness + scripted);
    return a.owned & (bit(0u, dot(a.a - p.xyz, n) + min(0.0, dot(a.ahead_a, n)) < reach.x) |
                      bit(1u, dot(a.b - p.xyz, n) + min(0.0, dot(a.ahead_b, n)) < reach.y) |
                      bit(2u, dot(a.c - p.xyz, n) + min(0.0, dot(a.ahead_c, n)) < reach.z));
  }
  let radius = params.thickness + p.w + scripted;
  let none = kColliderPoint | point;
  var hits = bit(3u, corner_near(p.xyz, vec3f(0.0), 0.0, none, a, radius));
  if (kind == kNearSphere) { return hits; }
  let q = points[point + 2u].xyz;
  hits |= bit(4u, corner_near(q, vec3f(0.0), 0.0, none, a, radius));
  let axis = Edge(p.xyz, q, vec3f(0.0), vec3f(0.0), vec2u(kColliderPoint), 0.0);
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (8u << k)) != 0u) { hits |= bit(k, edges_near(edge_of(a, k), axis, radius)); }
  }
  return hits;
}

fn corner_id(ids : vec3u, k : u32) -> u32 { return select(select(ids.z, ids.y, k == 1u), ids.x, k == 0u); }
fn edge_ids(ids : vec3u, k : u32) -> vec2u { return select(select(ids.zx, ids.yz, k == 1u), ids.xy, k == 0u); }

fn pair_of_faces(a : vec3u, b : vec3u, hit : u32) -> vec4u {
  if (hit < 3u) { return vec4u(corner_id(a, hit), b); }
  if (hit < 6u) { return vec4u(corner_id(b, hit - 3u), a); }
  return vec4u(edge_ids(a, (hit - 6u) / 3u), edge_ids(b, (hit - 6u) % 3u)) | vec4u(kPairFlag, 0u, 0u, 0u);
}
fn pair_of_shape(a : vec3u, kind : u32, point : u32, hit : u32) -> vec4u {
  let id = kColliderPoint | point;
  if (kind == kNearPlane) { return vec4u(corner_id(a, hit), id | kPairFlag, 0u, 0u); }
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
  let p = select(select(own.c, own.b, k == 1u), own.a, k == 0u);
  let q = select(select(own.a, own.c, k == 1u), own.b, k == 0u);
  let tip = select(select(own.b, own.a, k == 1u), own.c, k == 0u);
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

@compute @workgroup_size(kWorkgroupSize)
fn find_pairs(@builtin(workgroup_id) group : vec3u, @builtin(num_workgroups) groups : vec3u,
              @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    let works = atomicLoad(&statistics[kStatDue]) != 0u && atomicLoad(&statistics[kStatRolledBack]) == 0u;
    count = select(0u, atomicLoad(&statistics[kStatCandidates]), works);
  }
  let end = workgroupUniformLoad(&count);
  for (var first = group.x * kWorkgroupSize; first < end; first += groups.x * kWorkgroupSize) {
    var hits = 0u;
    var candidate = vec2u(0u);
    var kind = 0u;
    var ids_a = vec3u(0u);
    var ids_b = vec3u(0u);
    var friction = 0.0;
    if (first + thread < end) {
      candidate = candidates[first + thread];
      kind = candidate.x >> kKindShift;
      let own = candidate.x & kPlaceBits;
      let a = cloth_face(own);
      friction = f32(triangles[own].w >> 8u) * kFrictionUnit;
      ids_a = a.ids;
      if (kind >= kNearSphere) {
        hits = near_shape(a, kind, candidate.y);
      } else {
        let b = other_face(candidate);
        hits = near_features(a, b, select(params.thickness, params.self_thickness, kind == kNearCloth));
        ids_b = b.ids;
        if (overlap(box_of(a.a, a.b, a.c), box_of(b.a, b.b, b.c))) {
          let of_a = crossing_edges(a, b);
          let of_b = crossing_edges(b, a);
          if ((of_a | of_b) != 0u) {
            atomicAdd(&statistics[kStatCrossingsLeft], countOneBits(of_a) + countOneBits(of_b));
            let twice = select(of_a, of_a | (of_b << 3u), kind == kNearCloth);
            hits |= (of_a | (of_b << 3u) | (twice << kByOtherEnd)) << kFirstCrossing;
          }
        }
      }
    }
    let wanted = countOneBits(hits);
    var pair = allocate(thread, wanted, kStatPairs);
    if (wanted > 0u && pair + wanted > params.pair_capacity) { atomicStore(&statistics[kStatRolledBack], 1u); }
    while (hits != 0u && pair < params.pair_capacity) {
      let hit = firstTrailingBit(hits);
      hits &= hits - 1u;
      if (hit >= kFirstCrossing) {
        let a = cloth_face(candidate.x & kPlaceBits);
        let b = other_face(candidate);
        let edge = (hit - kFirstCrossing) % kByOtherEnd;
        let second = hit >= kFirstCrossing + kByOtherEnd;
        if (edge < 3u) {
          list_crossing(a, candidate.x & kPlaceBits, edge, b, second, pair);
        } else {
          list_crossing(b, candidate.y, edge - 3u, a, second, pair);
        }
        pair++;
        continue;
      }
      var ids = pair_of_faces(ids_a, ids_b, hit);
      if (kind >= kNearSphere) { ids = pair_of_shape(ids_a, kind, candidate.y, hit); }
      var thickness = params.thickness;
      if (kind == kNearCloth) { thickness = thickness_of(ids); }
      listed[pair] = ListedPair(ids, vec4u(bitcast<u32>(thickness), bitcast<u32>(friction), 0u, 0u));
      pair++;
    }
  }
}
