// Finds the pairs of features nearer than their radius: first counts them, then, run again, writes them where the counts
// say. One invocation per cloth triangle; it walks the cloth's own tree for later triangles, and every collider.
// A vertex or edge belongs to one of its triangles, so that each pair of features is found once (Curtis et al. 2008, Fast Collision
// Detection for Deformable Models using Representative-Triangles).
#include "shared/index.wgsl"
#include "shared/step.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
#include "contact/tree.wgsl"
#include "contact/closest.wgsl"
#include "contact/crossing.wgsl"
struct FindParams {  // mirror: src/collision/find_pairs.hpp
  fill : u32,            // 0: count; 1: write
  candidates : u32,      // 1: every pair of triangles whose grown boxes overlap, instead of features
  triangle_count : u32,  // of the cloths
  collider_count : u32,
  self_contact : u32,    // 1: cloth meets cloth
  tree : u32,            // first word of the cloths' tree
  first_row : u32,       // of `points`: three rows for each collider, where it stands in the world
  first_block : u32,     // of `lists`: where the blocks begin
  radius : f32,          // m, cloth and collider; with twice the reach features are listed
  self_radius : f32,     // m, cloth and cloth
}
// A collider: its kind, then
const kColliderTree = 0u;       // a rigid mesh: first word of its nodes, first word of its triangles, its number
const kColliderImplicit = 1u;   // a mesh that deforms: first word of its tree, its first triangle of `triangles`, their number
const kColliderSphere = 2u;     // its point
const kColliderCapsule = 3u;    // its point; the other end is two further
const kColliderPlane = 4u;      // its point; the normal is the next
const kMostColliders = 1024u;
struct Colliders { list : array<vec4u, kMostColliders> }
//                                                                                     elements
@group(0) @binding(0) var<uniform>             step            : StepParams;
@group(0) @binding(1) var<uniform>             params          : FindParams;
@group(0) @binding(2) var<uniform>             colliders       : Colliders;
@group(0) @binding(3) var<storage, read>       position        : array<vec4f>;        // vertex_count, m
@group(0) @binding(4) var<storage, read>       triangles       : array<vec4u>;        // in tree order: corners; w: bits of what it owns, friction
@group(0) @binding(5) var<storage, read>       trees           : array<vec4u>;
@group(0) @binding(6) var<storage, read>       points          : array<vec4f>;        // of colliders; see contact/move_points.wgsl
@group(0) @binding(7) var<storage, read_write> lists           : array<u32>;          // a triangle: how many pairs it finds, then where they begin in its block
@group(0) @binding(8) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(9) var<storage, read_write> vertex_contacts : array<atomic<u32>>;  // see shared/contact.wgsl
@group(0) @binding(10) var<storage, read_write> statistics     : array<atomic<u32>>;

// A triangle and what it owns: bits 0 to 2 its corners, 3 to 5 the edges from them.
struct Face {
  points : array<vec3f, 3>,  // m
  ids : vec3u,
  owned : u32,
  friction : f32,
}
const kFrictionUnit = 7.62939453125e-06;  // 2^-17, in bits 8 to 31 of a triangle's w

var<private> found : u32;       // pairs so far
var<private> room : u32;        // for how many, where they are written
var<private> first_pair : u32;
var<private> crossings : u32;

fn emit(ids : vec4u, friction : f32) {
  if (params.fill == 1u && found < room) {
    contacts[first_pair + found].ids = ids;
    contacts[first_pair + found].surface = vec4f(0.0, 0.0, 0.0, friction);
    for (var role = 0u; role < role_count(ids); role++) {
      if (!is_collider(ids[role])) { atomicAdd(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + 1u], 1u); }
    }
  }
  found++;
}

fn cloth_face(t : u32) -> Face {
  let corner = triangles[t];
  return Face(array(position[corner.x].xyz, position[corner.y].xyz, position[corner.z].xyz), corner.xyz, corner.w & 63u,
              f32(corner.w >> 8u) * kFrictionUnit);
}
fn face_is_finite(f : Face) -> bool { return is_finite(f.points[0]) && is_finite(f.points[1]) && is_finite(f.points[2]); }
fn face_box(f : Face) -> Box { return box_of(f.points[0], f.points[1], f.points[2]); }

// All pairs of features of two triangles. Ids of colliders bear their mark, so only cloth's can be equal.
fn pair_faces(a : Face, b : Face, radius : f32) {
  let limit = radius * radius;
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (1u << k)) != 0u && all(b.ids != vec3u(a.ids[k]))) {
      let near = closest_on_triangle(a.points[k], b.points[0], b.points[1], b.points[2]);
      if (dot(near.apart, near.apart) < limit) { emit(vec4u(a.ids[k], b.ids), a.friction); }
    }
    if ((b.owned & (1u << k)) != 0u && all(a.ids != vec3u(b.ids[k]))) {
      let near = closest_on_triangle(b.points[k], a.points[0], a.points[1], a.points[2]);
      if (dot(near.apart, near.apart) < limit) { emit(vec4u(b.ids[k], a.ids), a.friction); }
    }
  }
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (8u << k)) == 0u) { continue; }
    let k1 = (k + 1u) % 3u;
    for (var l = 0u; l < 3u; l++) {
      if ((b.owned & (8u << l)) == 0u) { continue; }
      let l1 = (l + 1u) % 3u;
      let ids = vec4u(a.ids[k], a.ids[k1], b.ids[l], b.ids[l1]);
      if (any(ids.xy == ids.zz) || any(ids.xy == ids.ww)) { continue; }
      let near = closest_on_edges(a.points[k], a.points[k1], b.points[l], b.points[l1]);
      if (dot(near.apart, near.apart) < limit) { emit(ids | vec4u(kPairFlag, 0u, 0u, 0u), a.friction); }
    }
  }
  if (params.fill == 0u && overlap(face_box(a), face_box(b))) { crossings += count_crossings(a, b) + count_crossings(b, a); }
}

// The edges of `a`, each counted by its owner, that pass through `b`.
fn count_crossings(a : Face, b : Face) -> u32 {
  var count = 0u;
  for (var k = 0u; k < 3u; k++) {
    let k1 = (k + 1u) % 3u;
    if ((a.owned & (8u << k)) == 0u || any(b.ids == vec3u(a.ids[k])) || any(b.ids == vec3u(a.ids[k1]))) { continue; }
    if (crosses(a.points[k], a.points[k1], b.points[0], b.points[1], b.points[2])) { count++; }
  }
  return count;
}

// Tests a triangle of a tree's leaf whose box may overlap.
fn meet(t : u32, face : Face, box : Box, a : Face, radius : f32) {
  if (!face_is_finite(face) || !overlap(box, face_box(face))) { return; }
  if (params.candidates == 1u) {
    emit(vec4u(a.ids.x, face.ids.x, t, 0u), 0.0);
  } else {
    pair_faces(a, face, radius);
  }
}

// Which children of a node overlap the box, as bits; none whose triangles all come before `after`.
fn child_hits(tree : u32, level : u32, node : u32, box : Box, after : u32) -> u32 {
  let place = trees[tree + level];  // of the level below
  var hits = 0u;
  for (var k = 0u; k < kTreeArity; k++) {
    let child = kTreeArity * node + k;
    if (child >= place.y) { break; }
    let low = bitcast<vec3f>(trees[place.x + 2u * child].xyz);
    let high = bitcast<vec3f>(trees[place.x + 2u * child + 1u].xyz);
    let last = kLeafTriangles * ((child + 1u) << (3u * (level - 1u)));
    if (last > after && overlap(box, Box(low, high))) { hits |= 1u << k; }
  }
  return hits;
}

// Walks an implicit tree. What is left of each level waits as eight bits: of the lower four levels in one word, of the upper
// four in another.
fn walk_implicit(tree : u32, first_triangle : u32, count : u32, mark : u32, after : u32, box : Box, a : Face, radius : f32) {
  let top = trees[tree].x;
  var waiting = vec2u(0u);
  var level = top;
  var node = 0u;
  var hits = child_hits(tree, level, node, box, after);
  loop {
    if (hits == 0u) {
      if (level == top) { break; }
      level++;
      node = node >> 3u;
      let shift = 8u * (level & 3u);
      hits = (select(waiting.x, waiting.y, level > 3u) >> shift) & 255u;
      continue;
    }
    let child = kTreeArity * node + firstTrailingBit(hits);
    hits &= hits - 1u;
    if (level == 1u) {
      let end = min(kLeafTriangles * (child + 1u), count);
      for (var t = max(kLeafTriangles * child, after); t < end; t++) {
        var face = cloth_face(first_triangle + t);
        if (mark != 0u) {
          let corner = triangles[first_triangle + t];
          face.points = array(points[corner.x].xyz, points[corner.y].xyz, points[corner.z].xyz);
          face.ids = corner.xyz | vec3u(mark);
        }
        meet(mark | t, face, box, a, radius);
      }
    } else {
      let shift = 8u * (level & 3u);
      if (level > 3u) {
        waiting.y = (waiting.y & ~(255u << shift)) | (hits << shift);
      } else {
        waiting.x = (waiting.x & ~(255u << shift)) | (hits << shift);
      }
      level--;
      node = child;
      hits = child_hits(tree, level, node, box, after);
    }
  }
}

// Walks the tree of a rigid mesh (src/collision/object_tree.hpp) in the mesh's own space.
const kStackSize = 32u;
fn walk_rigid(collider : vec4u, a : Face, radius : f32) {
  let row = params.first_row + 3u * collider.w;
  let rx = points[row];
  let ry = points[row + 1u];
  let rz = points[row + 2u];
  let shift = vec3f(rx.w, ry.w, rz.w);
  var local = a;
  for (var k = 0u; k < 3u; k++) {
    let p = a.points[k] - shift;
    local.points[k] = p.x * rx.xyz + p.y * ry.xyz + p.z * rz.xyz;  // the rotation's transpose
  }
  let box = grown(face_box(local), radius);
  var stack : array<u32, kStackSize>;
  var size = 1u;
  while (size > 0u) {
    size--;
    let node = collider.y + 8u * stack[size];
    let child = trees[node + 6u];
    let hit = (vec4f(box.low.x) <= bitcast<vec4f>(trees[node + 3u])) & (bitcast<vec4f>(trees[node]) <= vec4f(box.high.x)) &
              (vec4f(box.low.y) <= bitcast<vec4f>(trees[node + 4u])) & (bitcast<vec4f>(trees[node + 1u]) <= vec4f(box.high.y)) &
              (vec4f(box.low.z) <= bitcast<vec4f>(trees[node + 5u])) & (bitcast<vec4f>(trees[node + 2u]) <= vec4f(box.high.z));
    for (var k = 0u; k < 4u; k++) {
      if (!hit[k]) { continue; }
      let count = child[k] % 8u;
      let index = child[k] / 8u;
      if (count == 0u) {
        if (index > 0u && size < kStackSize) { stack[size] = index; size++; }
        continue;
      }
      for (var t = index; t < index + count; t++) {
        let word = collider.z + 3u * t;
        let p = trees[word];
        let q = trees[word + 1u];
        let r = trees[word + 2u];
        let owners = vec3u(p.w, q.w, r.w) >> vec3u(30u);  // of each corner: bit 0 the corner, bit 1 the edge from it
        let corners = (owners & vec3u(1u)) << vec3u(0u, 1u, 2u);
        let edges = (owners >> vec3u(1u)) << vec3u(3u, 4u, 5u);
        let face = Face(array(bitcast<vec3f>(p.xyz), bitcast<vec3f>(q.xyz), bitcast<vec3f>(r.xyz)),
                        (vec3u(p.w, q.w, r.w) & vec3u(kIdBits)) | vec3u(kColliderPoint),
                        corners.x | corners.y | corners.z | edges.x | edges.y | edges.z, 0.0);
        meet(kColliderPoint | (collider.w << 24u) | t, face, box, local, radius);
      }
    }
  }
}

fn meet_sphere(point : u32, a : Face, radius : f32) {
  let ball = points[point];
  let near = closest_on_triangle(ball.xyz, a.points[0], a.points[1], a.points[2]);
  if (length(near.apart) < ball.w + radius) { emit(vec4u(kColliderPoint | point, a.ids), a.friction); }
}

fn meet_capsule(point : u32, a : Face, radius : f32) {
  let start = points[point];
  let end = points[point + 2u];
  meet_sphere(point, a, radius);
  meet_sphere(point + 2u, a, radius);
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (8u << k)) == 0u) { continue; }
    let k1 = (k + 1u) % 3u;
    let near = closest_on_edges(a.points[k], a.points[k1], start.xyz, end.xyz);
    if (length(near.apart) >= start.w + radius) { continue; }
    emit(vec4u(a.ids[k] | kPairFlag, a.ids[k1], kColliderPoint | point, kColliderPoint | (point + 2u)), a.friction);
  }
}

fn meet_plane(point : u32, a : Face, radius : f32) {
  for (var k = 0u; k < 3u; k++) {
    if ((a.owned & (1u << k)) == 0u) { continue; }
    if (dot(a.points[k] - points[point].xyz, points[point + 1u].xyz) >= radius) { continue; }
    emit(vec4u(a.ids[k], kColliderPoint | kPairFlag | point, 0u, 0u), a.friction);
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn find_pairs(@builtin(global_invocation_id) id : vec3u) {
  let own = flat_index(id);
  if (own >= params.triangle_count || atomicLoad(&statistics[kStatDue]) == 0u) { return; }
  if (params.fill == 1u) {
    if (atomicLoad(&statistics[kStatPairs]) == 0u) { return; }
    first_pair = lists[own] + lists[params.first_block + own / kScanBlock];
    var next = atomicLoad(&statistics[kStatPairs]);
    if (own + 1u < params.triangle_count) {
      next = lists[own + 1u] + lists[params.first_block + (own + 1u) / kScanBlock];
    }
    room = max(next, first_pair) - first_pair;
    if (room == 0u) { return; }
  }
  let a = cloth_face(own);
  let reach = 2.0 * bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  if (face_is_finite(a)) {
    if (params.self_contact == 1u) {
      walk_implicit(params.tree, 0u, params.triangle_count, 0u, own + 1u, grown(face_box(a), params.self_radius + reach), a,
                    params.self_radius + reach);
    }
    for (var c = 0u; c < params.collider_count; c++) {
      let collider = colliders.list[c];
      if (collider.x == kColliderTree) { walk_rigid(collider, a, params.radius + reach); }
      if (collider.x == kColliderImplicit) {
        walk_implicit(collider.y, collider.z, collider.w, kColliderPoint, 0u, grown(face_box(a), params.radius + reach), a, params.radius + reach);
      }
      if (collider.x == kColliderSphere) { meet_sphere(collider.y, a, params.radius + reach); }
      if (collider.x == kColliderCapsule) { meet_capsule(collider.y, a, params.radius + reach); }
      if (collider.x == kColliderPlane) { meet_plane(collider.y, a, params.radius + reach); }
    }
  }
  if (params.fill == 0u) {
    lists[own] = found;
    if (crossings > 0u) { atomicAdd(&statistics[kStatFound], crossings); }
  }
}
