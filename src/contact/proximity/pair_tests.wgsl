// The tests of the narrow phase, of a corner and a triangle or of two edges, and how a workgroup shares them out. The
// including kernel binds `params`, `predicted`, `triangles`, `trees` and `points`.
#include "state/contact.wgsl"
#include "contact/proximity/closest.wgsl"
#include "contact/proximity/triangles.wgsl"
const kTesters = 128u;  // invocations of a workgroup; mirror: src/contact/proximity/pair_search.cpp
const kMostTests = 15u;  // of a candidate

// The three corners of a triangle, m, and the features that it owns: bits 0 to 2 its corners, 3 to 5 the edges from
// them.
struct Face {
  a : vec3f, b : vec3f, c : vec3f,
  ids : vec3u,
  owned : u32,
}

var<workgroup> scripted : f32;  // how far a collider may go until the next search, m
var<workgroup> taken : array<vec2u, kTesters>;  // candidates
// Tests: the place of its candidate in `taken`, times 16, and which one, as owned_tests has it. Those of a corner and a
// triangle from the front, those of two edges from the end, since the two take different ways.
var<workgroup> tests : array<u32, kMostTests * kTesters>;
var<workgroup> corner_tests : atomic<u32>;
var<workgroup> edge_tests : atomic<u32>;
var<workgroup> test_counts : vec2u;

// The first triangle of a candidate: its corners, and in w what it owns.
fn own_triangle(candidate : vec2u) -> vec4u {
  let corner = triangles[candidate.x & kPlaceBits];
  return vec4u(corner.xyz, corner.w & 63u);
}
// Its other side, if that is a triangle.
fn other_triangle(candidate : vec2u) -> vec4u {
  let kind = candidate.x >> kKindShift;
  if (kind != kNearRigid) {
    let corner = triangles[candidate.y];
    let mark = select(0u, kColliderPoint, kind == kNearDeforming);
    return vec4u(corner.xyz | vec3u(mark), corner.w & 63u);
  }
  let w = vec3u(trees[candidate.y].w, trees[candidate.y + 1u].w, trees[candidate.y + 2u].w);
  let corners = ((w >> vec3u(30u)) & vec3u(1u)) << vec3u(0u, 1u, 2u);  // bit 30: owns the corner; 31: its edge
  let edges = (w >> vec3u(31u)) << vec3u(3u, 4u, 5u);
  return vec4u((w & vec3u(kIdBits)) | vec3u(kColliderPoint),
               corners.x | corners.y | corners.z | edges.x | edges.y | edges.z);
}

fn place_of(id : u32) -> vec3f {
  if ((id & kColliderPoint) != 0u) { return points[id & kIdBits].xyz; }
  return predicted[params.vertex_count + id].xyz;
}
fn face_of(triangle : vec4u) -> Face {
  return Face(place_of(triangle.x), place_of(triangle.y), place_of(triangle.z), triangle.xyz, triangle.w);
}

// Where a vertex is, m, how far it may go beside its way, m, and its way ahead, m.
struct Corner {
  at : vec3f,
  slack : f32,
  ahead : vec3f,
}
fn corner_of(id : u32) -> Corner {
  if ((id & kColliderPoint) != 0u) { return Corner(points[id & kIdBits].xyz, scripted, vec3f(0.0)); }
  let place = predicted[params.vertex_count + id];
  return Corner(place.xyz, place.w, predicted[2u * params.vertex_count + id].xyz);
}

// How far a way leads against a direction, m.
fn way_against(n : vec3f, corner : Corner) -> f32 { return max(0.0, -dot(n, corner.ahead)); }

// Whether a vertex and a triangle may come nearer than the radius (docs/contact.md, equation (6a)). On each side one
// vertex may go its way ahead while the other side stops, so only what brings that side nearer counts.
fn corner_near(p : Corner, a : Corner, b : Corner, c : Corner, radius : f32) -> bool {
  let apart = closest_on_triangle(p.at, a.at, b.at, c.at).apart;
  let reach = radius + p.slack + max(max(a.slack, b.slack), c.slack);
  let distance = length(apart);
  if (distance <= 0.0) { return true; }
  let n = apart / distance;
  return distance < reach + way_against(n, p) + max(max(way_against(-n, a), way_against(-n, b)), way_against(-n, c));
}
// The same of two edges.
fn edges_near(p : Corner, q : Corner, r : Corner, s : Corner, radius : f32) -> bool {
  let apart = closest_on_edges(p.at, q.at, r.at, s.at).apart;
  let reach = radius + max(p.slack, q.slack) + max(r.slack, s.slack);
  let distance = length(apart);
  if (distance <= 0.0) { return true; }
  let n = apart / distance;
  return distance < reach + max(way_against(n, p), way_against(n, q)) + max(way_against(-n, r), way_against(-n, s));
}

fn bit(k : u32, near : bool) -> u32 { return select(0u, 1u << k, near); }
fn corner_id(ids : vec3u, k : u32) -> u32 { return select(select(ids.z, ids.y, k == 1u), ids.x, k == 0u); }
fn edge_ids(ids : vec3u, k : u32) -> vec2u { return select(select(ids.zx, ids.yz, k == 1u), ids.xy, k == 0u); }

// The pairs of features that two triangles own and do not share, as bits: 0 to 2 corners of a with b, 3 to 5 corners of
// b with a, 6 + 3 k + l edge k of a with edge l of b.
fn owned_tests(a : vec4u, b : vec4u) -> u32 {
  var wanted = 0u;
  for (var k = 0u; k < 3u; k++) {
    wanted |= bit(k, (a.w & (1u << k)) != 0u && all(b.xyz != vec3u(corner_id(a.xyz, k))));
    wanted |= bit(3u + k, (b.w & (1u << k)) != 0u && all(a.xyz != vec3u(corner_id(b.xyz, k))));
    let edge = edge_ids(a.xyz, k);
    for (var l = 0u; l < 3u; l++) {
      let other = edge_ids(b.xyz, l);
      wanted |= bit(6u + 3u * k + l, (a.w & (8u << k)) != 0u && (b.w & (8u << l)) != 0u && all(edge != other) &&
                                     all(edge != other.yx));
    }
  }
  return wanted;
}
const kCornerTests = 63u;
fn pair_of_faces(a : vec3u, b : vec3u, hit : u32) -> vec4u {
  if (hit < 3u) { return vec4u(corner_id(a, hit), b); }
  if (hit < 6u) { return vec4u(corner_id(b, hit - 3u), a); }
  return vec4u(edge_ids(a, (hit - 6u) / 3u), edge_ids(b, (hit - 6u) % 3u)) | vec4u(kPairFlag, 0u, 0u, 0u);
}

// Puts a candidate's tests where the workgroup's are.
fn hand_out(thread : u32, wanted : u32) {
  let of_corners = countOneBits(wanted & kCornerTests);
  let of_edges = countOneBits(wanted & ~kCornerTests);
  var corner_place = 0u;
  var edge_place = 0u;
  if (of_corners > 0u) { corner_place = atomicAdd(&corner_tests, of_corners); }
  if (of_edges > 0u) { edge_place = kMostTests * kTesters - of_edges - atomicAdd(&edge_tests, of_edges); }
  for (var left = wanted; left != 0u; left &= left - 1u) {
    let test = firstTrailingBit(left);
    if (test < 6u) {
      tests[corner_place] = (thread << 4u) | test;
      corner_place++;
    } else {
      tests[edge_place] = (thread << 4u) | test;
      edge_place++;
    }
  }
}
fn test_at(k : u32) -> u32 {
  if (k < test_counts.x) { return tests[k]; }
  return tests[kMostTests * kTesters - test_counts.y + (k - test_counts.x)];
}

fn is_near(test : u32) -> bool {
  let candidate = taken[test >> 4u];
  let radius = select(params.thickness, params.self_thickness, candidate.x >> kKindShift == kNearCloth);
  let ids = pair_of_faces(own_triangle(candidate).xyz, other_triangle(candidate).xyz, test & 15u);
  let first = corner_of(ids.x & ~kPairFlag);
  let second = corner_of(ids.y);
  let third = corner_of(ids.z);
  let fourth = corner_of(ids.w);
  if ((test & 15u) < 6u) { return corner_near(first, second, third, fourth, radius); }
  return edges_near(first, second, third, fourth, radius);
}
