// Broad phase: finds the candidates near each cloth triangle, by boxes grown by thickness and reaches. One invocation
// per cloth triangle; of small cloths kLanes, each of which begins at another child of a root, since a walk waits for
// memory at each node and few walks fill no adapter. It walks the cloths' own tree for later triangles, and every
// collider: once to count and, if it found many, once more to write. The list's order depends on scheduling; no result
// depends on the order. Source: docs/contact.md.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
#include "contact/proximity/allocate.wgsl"
// A collider: its kind, then
const kColliderTree = 0u;       // a rigid mesh: first word of its nodes, first word of its triangles, its number
const kColliderImplicit = 1u;   // a deforming mesh: first word of its tree, first of its `triangles`, their number
const kColliderSphere = 2u;     // its point
const kColliderCapsule = 3u;    // its point; the other end is two further
const kColliderPlane = 4u;      // its point; the normal is the next
const kMostColliders = 1024u;
struct Colliders { list : array<vec4u, kMostColliders> }
//                                                                           elements
@group(0) @binding(0) var<uniform>             params     : SearchParams;
@group(0) @binding(1) var<uniform>             colliders  : Colliders;
@group(0) @binding(2) var<storage, read>       predicted  : array<vec4f>; // 3 * vertex_count: reach.wgsl
@group(0) @binding(3) var<storage, read>       triangles  : array<vec4u>; // corners; w: owned, friction
@group(0) @binding(4) var<storage, read>       trees      : array<vec4u>;
@group(0) @binding(5) var<storage, read>       points     : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(6) var<storage, read_write> candidates : array<vec2u>; // candidate_capacity
@group(0) @binding(7) var<storage, read_write> statistics : array<atomic<u32>>;

override kLanes : u32 = 1;  // or kTreeArity; the trees of rigid meshes have four children a node
const kMostKept = 32u;
var<private> lane : u32;
var<private> found : u32;
var<private> kept : array<vec2u, kMostKept>;  // the first of them
var<private> next : u32;  // where to write, once `writing`
var<private> writing : bool;
var<private> own : u32;
var<private> corners : vec3u;
var<private> a : vec3f;  // the corners' places, m
var<private> b : vec3f;
var<private> c : vec3f;
var<private> ahead_a : vec3f;  // their ways ahead, m
var<private> ahead_b : vec3f;
var<private> ahead_c : vec3f;
var<private> own_box : Box;    // of all that the triangle may pass on its ways ahead
var<private> own_reach : f32;  // its slack, and how far its corners go along their ways, m
var<private> own_slack : f32;
var<workgroup> due : u32;

fn emit(kind : u32, place : u32) {
  if (writing) {
    candidates[next] = vec2u(own | (kind << kKindShift), place);
    next++;
  } else {
    if (found < kMostKept) { kept[found] = vec2u(own | (kind << kKindShift), place); }
    found++;
  }
}

// Whether two triangles that share an edge have no features, other than shared ones, within the thickness and all that
// both may go. Laid flat on either side of their edge they have none nearer than their shortest altitude a; bent, with
// c the cosine between their faces, 1 where they lie flat, none nearer than a sqrt((1 + c) / 2).
fn lie_flat(other : vec3u, d : vec3f, e : vec3f, f : vec3f, way : f32) -> bool {
  let same_a = vec3<bool>(corners.x == other.x || corners.x == other.y || corners.x == other.z,
                          corners.y == other.x || corners.y == other.y || corners.y == other.z,
                          corners.z == other.x || corners.z == other.y || corners.z == other.z);
  let shared_count = select(0u, 1u, same_a.x) + select(0u, 1u, same_a.y) + select(0u, 1u, same_a.z);
  if (shared_count != 2u) { return false; }
  let first = select(b, a, same_a.x);
  let along = select(b, c, same_a.z) - first;
  let u = (a - first) + (b - first) + (c - first) - along;  // to the corner that is not shared
  let v = (d - first) + (e - first) + (f - first) - along;
  let area = cross(u, along);
  let other_area = cross(v, along);
  let size = dot(along, along);
  let longest = max(max(size, dot(u, u)), dot(u - along, u - along));
  let other_longest = max(max(size, dot(v, v)), dot(v - along, v - along));
  let areas = length(area) * length(other_area);
  if (!(areas > 0.0)) { return false; }
  let shortened = 0.5 - 0.5 * dot(area, other_area) / areas;
  let least = (params.self_thickness + way) * (params.self_thickness + way);
  return shortened * dot(area, area) > least * longest &&
         shortened * dot(other_area, other_area) > least * other_longest;
}

// Which children of a node overlap the box, as bits; none whose triangles all come before `after`.
fn child_hits(tree : u32, level : u32, node : u32, box : Box, after : u32) -> u32 {
  let place = trees[tree + level];  // of the level below
  var hits = 0u;
  for (var k = 0u; k < kTreeArity; k++) {
    let child = kTreeArity * node + k;
    let word = place.x + 2u * min(child, place.y - 1u);
    let low = bitcast<vec3f>(trees[word].xyz);
    let high = bitcast<vec3f>(trees[word + 1u].xyz);
    let last = kLeafTriangles * ((child + 1u) << (3u * (level - 1u)));
    hits |= select(0u, 1u << k, child < place.y && last > after && overlap(box, Box(low, high)));
  }
  return hits;
}

// Tests the triangles of a leaf.
fn meet_leaf(first : u32, begin : u32, end : u32, deforming : bool, box : Box) {
  for (var t = begin; t < end; t++) {
    let other = triangles[first + t];
    if (deforming) {
      let d = points[other.x].xyz;
      let e = points[other.y].xyz;
      let f = points[other.z].xyz;
      let finite = is_finite(d) && is_finite(e) && is_finite(f);
      if (overlap(box, box_of(d, e, f)) && finite) { emit(kNearDeforming, first + t); }
      continue;
    }
    let d = predicted[params.vertex_count + other.x];
    let e = predicted[params.vertex_count + other.y];
    let f = predicted[params.vertex_count + other.z];
    let slack = largest_reach(d, e, f);
    let ahead_d = predicted[2u * params.vertex_count + other.x].xyz;
    let ahead_e = predicted[2u * params.vertex_count + other.y].xyz;
    let ahead_f = predicted[2u * params.vertex_count + other.z].xyz;
    if (!overlap(box, grown(swept_box(d.xyz, e.xyz, f.xyz, ahead_d, ahead_e, ahead_f), slack))) { continue; }
    if (!(is_finite(d.xyz) && is_finite(e.xyz) && is_finite(f.xyz))) { continue; }
    let reach = slack + max(max(length(ahead_d), length(ahead_e)), length(ahead_f));
    if (!lie_flat(other.xyz, d.xyz, e.xyz, f.xyz, own_reach + reach)) { emit(kNearCloth, t); }
  }
}

// Traverses an implicit tree. The open siblings of each level are stored as eight bits: of the lower four levels in one
// word, of the upper four in another.
fn walk_implicit(tree : u32, first : u32, count : u32, deforming : bool, after : u32, box : Box) {
  let top = trees[tree].x;
  var waiting = vec2u(0u);
  var level = top;
  var node = 0u;
  var hits = child_hits(tree, level, node, box, after) & select(255u, 1u << lane, kLanes > 1u);
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
      let begin = kLeafTriangles * child;
      meet_leaf(first, max(begin, after), min(begin + kLeafTriangles, count), deforming, box);
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

// A point in the space of a collider: the transpose of its rotation.
fn local(collider : u32, p : vec3f) -> vec3f {
  let row = params.first_row + 3u * collider;
  let rx = points[row];
  let ry = points[row + 1u];
  let rz = points[row + 2u];
  let d = p - vec3f(rx.w, ry.w, rz.w);
  return d.x * rx.xyz + d.y * ry.xyz + d.z * rz.xyz;
}

// Walks the tree of a rigid mesh (src/contact/object_tree.hpp) in the mesh's own space.
const kStackSize = 32u;
fn walk_rigid(collider : vec4u, radius : f32) {
  let m = collider.w;
  let box = grown(united(box_of(local(m, a), local(m, b), local(m, c)),
                         box_of(local(m, a + ahead_a), local(m, b + ahead_b), local(m, c + ahead_c))), radius);
  var stack : array<u32, kStackSize>;
  var size = 1u;
  var at_root = true;
  while (size > 0u) {
    size--;
    let node = collider.y + 8u * stack[size];
    let child = trees[node + 6u];
    let hit = (vec4f(box.low.x) <= bitcast<vec4f>(trees[node + 3u])) &
              (bitcast<vec4f>(trees[node]) <= vec4f(box.high.x)) &
              (vec4f(box.low.y) <= bitcast<vec4f>(trees[node + 4u])) &
              (bitcast<vec4f>(trees[node + 1u]) <= vec4f(box.high.y)) &
              (vec4f(box.low.z) <= bitcast<vec4f>(trees[node + 5u])) &
              (bitcast<vec4f>(trees[node + 2u]) <= vec4f(box.high.z));
    for (var k = 0u; k < 4u; k++) {
      if (!hit[k] || (kLanes > 1u && at_root && k != lane)) { continue; }
      let count = child[k] % 8u;
      let index = child[k] / 8u;
      if (count == 0u) {
        if (index > 0u && size < kStackSize) { stack[size] = index; size++; }
        continue;
      }
      for (var t = index; t < index + count; t++) {
        let word = collider.z + 3u * t;
        let other = box_of(bitcast<vec3f>(trees[word].xyz), bitcast<vec3f>(trees[word + 1u].xyz),
                           bitcast<vec3f>(trees[word + 2u].xyz));
        if (overlap(box, other)) { emit(kNearRigid, word); }
      }
    }
    at_root = false;
  }
}

fn meet_all(scripted_reach : f32) {
  let radius = params.thickness + own_slack + scripted_reach;
  let wide = grown(own_box, radius);
  if (params.self_contact == 1u) {
    walk_implicit(0u, 0u, params.triangle_count, false, own + 1u, grown(own_box, params.self_thickness + own_slack));
  }
  for (var k = 0u; k < params.collider_count; k++) {
    let collider = colliders.list[k];
    if (collider.x == kColliderTree) { walk_rigid(collider, radius); }
    if (collider.x == kColliderImplicit) { walk_implicit(collider.y, collider.z, collider.w, true, 0u, wide); }
    if (k % kLanes != lane) { continue; }  // shapes have no tree
    if (collider.x == kColliderSphere) {
      let ball = points[collider.y];
      if (overlap(grown(Box(ball.xyz, ball.xyz), ball.w), wide)) { emit(kNearSphere, collider.y); }
    }
    if (collider.x == kColliderCapsule) {
      let start = points[collider.y];
      let far = points[collider.y + 2u];
      let bounds = grown(Box(min(start.xyz, far.xyz), max(start.xyz, far.xyz)), start.w);
      if (overlap(bounds, wide)) { emit(kNearCapsule, collider.y); }
    }
    if (collider.x == kColliderPlane) {
      let q = points[collider.y].xyz;
      let n = points[collider.y + 1u].xyz;
      let lowest = select(own_box.high, own_box.low, n > vec3f(0.0));
      if (dot(lowest - q, n) < radius) { emit(kNearPlane, collider.y); }
    }
  }
}

@compute @workgroup_size(kWorkgroupSize)
fn find_candidates(@builtin(global_invocation_id) id : vec3u, @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) { due = atomicLoad(&statistics[kStatDue]); }
  if (workgroupUniformLoad(&due) == 0u) { return; }
  own = flat_index(id) / kLanes;
  lane = flat_index(id) % kLanes;
  let scripted_reach = bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  var works = own < params.triangle_count;
  if (works) {
    corners = triangles[own].xyz;
    let place_a = predicted[params.vertex_count + corners.x];
    let place_b = predicted[params.vertex_count + corners.y];
    let place_c = predicted[params.vertex_count + corners.z];
    a = place_a.xyz;
    b = place_b.xyz;
    c = place_c.xyz;
    ahead_a = predicted[2u * params.vertex_count + corners.x].xyz;
    ahead_b = predicted[2u * params.vertex_count + corners.y].xyz;
    ahead_c = predicted[2u * params.vertex_count + corners.z].xyz;
    own_box = swept_box(a, b, c, ahead_a, ahead_b, ahead_c);
    own_slack = largest_reach(place_a, place_b, place_c);
    own_reach = own_slack + max(max(length(ahead_a), length(ahead_b)), length(ahead_c));
    works = is_finite(a) && is_finite(b) && is_finite(c);
  }
  if (works) { meet_all(scripted_reach); }
  next = allocate(thread, found, kStatCandidates);
  if (found > 0u && next + found > params.candidate_capacity) { atomicStore(&statistics[kStatRolledBack], 1u); }
  if (next + found > params.candidate_capacity) { return; }
  if (found > kMostKept) {
    writing = true;
    meet_all(scripted_reach);
  } else {
    for (var k = 0u; k < found; k++) { candidates[next + k] = kept[k]; }
  }
}
