// Broad phase: finds the candidates near each cloth triangle, by boxes grown by thickness and reaches. One workgroup
// for kOwn cloth triangles, or some that share the trees out. They lie side by side, so it walks each tree once for all
// of them (walk.wgsl), the cloths' own for later triangles and those of colliders, and each invocation tests triangles
// met against their boxes. The list's order depends on scheduling; no result depends on the order.
// Source: docs/contact.md.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/tree.wgsl"
#include "contact/proximity/triangles.wgsl"
#include "contact/proximity/allocate.wgsl"
#include "contact/proximity/walk.wgsl"
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
@group(0) @binding(8) var<storage, read>       patches    : array<vec4f>; // find_open.wgsl

var<private> own : u32;
var<private> corners : vec3u;
var<private> a : vec3f;  // the corners' places, m
var<private> b : vec3f;
var<private> c : vec3f;
var<private> ahead_a : vec3f;  // their ways ahead, m
var<private> ahead_b : vec3f;
var<private> ahead_c : vec3f;
var<private> own_box : Box;    // of all that the triangle may pass on its ways ahead
var<private> own_slack : f32;
var<workgroup> due : u32;
var<workgroup> own_corners : array<vec3u, kOwn>;  // of the workgroup's triangles
var<workgroup> own_cells : array<vec4u, kOwn>;
var<workgroup> own_patches : array<u32, kOwn>;

// A cloth triangle: its corners' numbers and places, m; the largest of their slacks and ways ahead together, m.
struct Sheet {
  corners : vec3u,
  a : vec3f, b : vec3f, c : vec3f,
  reach : f32,
}
fn sheet_of(corners : vec3u) -> Sheet {
  let a = predicted[params.vertex_count + corners.x];
  let b = predicted[params.vertex_count + corners.y];
  let c = predicted[params.vertex_count + corners.z];
  let way = max(max(length(predicted[2u * params.vertex_count + corners.x].xyz),
                    length(predicted[2u * params.vertex_count + corners.y].xyz)),
                length(predicted[2u * params.vertex_count + corners.z].xyz));
  return Sheet(corners, a.xyz, b.xyz, c.xyz, largest_reach(a, b, c) + way);
}

// The corners of a triangle that another one has too, as bits.
fn shares(corners : vec3u, other : vec3u) -> u32 {
  return select(0u, 1u, any(other == corners.xxx)) | select(0u, 2u, any(other == corners.yyy)) |
         select(0u, 4u, any(other == corners.zzz));
}

// Whether two triangles that share two corners have no features, other than shared ones, within the thickness and all
// that both may go. Laid flat on either side of their edge they have none nearer than their shortest altitude a; bent,
// with c the cosine between their faces, 1 where they lie flat, none nearer than a sqrt((1 + c) / 2).
fn lie_flat(sheet : Sheet, other : Sheet) -> bool {
  let shared_corners = shares(sheet.corners, other.corners);
  let first = select(sheet.b, sheet.a, (shared_corners & 1u) != 0u);
  let along = select(sheet.b, sheet.c, (shared_corners & 4u) != 0u) - first;
  // Each to the corner that is not shared.
  let u = (sheet.a - first) + (sheet.b - first) + (sheet.c - first) - along;
  let v = (other.a - first) + (other.b - first) + (other.c - first) - along;
  let area = cross(u, along);
  let other_area = cross(v, along);
  let size = dot(along, along);
  let longest = max(max(size, dot(u, u)), dot(u - along, u - along));
  let other_longest = max(max(size, dot(v, v)), dot(v - along, v - along));
  let areas = length(area) * length(other_area);
  if (!(areas > 0.0)) { return false; }
  let shortened = 0.5 - 0.5 * dot(area, other_area) / areas;
  let within = params.self_thickness + sheet.reach + other.reach;
  let least = within * within;
  return shortened * dot(area, area) > least * longest &&
         shortened * dot(other_area, other_area) > least * other_longest;
}

// The box of a triangle of a tree; an empty one where it is not finite.
fn box_in(tree : Tree, place : u32) -> Box {
  if (tree.kind == kNearRigid) {
    return box_of(bitcast<vec3f>(trees[place].xyz), bitcast<vec3f>(trees[place + 1u].xyz),
                  bitcast<vec3f>(trees[place + 2u].xyz));
  }
  let corner = triangles[place];
  if (tree.kind == kNearDeforming) {
    let d = points[corner.x].xyz;
    let e = points[corner.y].xyz;
    let f = points[corner.z].xyz;
    return finite_box(d, e, f, box_of(d, e, f));
  }
  let d = predicted[params.vertex_count + corner.x];
  let e = predicted[params.vertex_count + corner.y];
  let f = predicted[params.vertex_count + corner.z];
  let box = swept_box(d.xyz, e.xyz, f.xyz, predicted[2u * params.vertex_count + corner.x].xyz,
                      predicted[2u * params.vertex_count + corner.y].xyz,
                      predicted[2u * params.vertex_count + corner.z].xyz);
  return finite_box(d.xyz, e.xyz, f.xyz, grown(box, largest_reach(d, e, f)));
}
fn finite_box(d : vec3f, e : vec3f, f : vec3f, box : Box) -> Box {
  if (is_finite(d) && is_finite(e) && is_finite(f)) { return box; }
  return empty_box();
}

// The first place of the list for what this invocation has found; the list's length where it has no room.
fn allocate_candidates(thread : u32, found : u32) -> u32 {
  let next = allocate(thread, found, kStatCandidates);
  if (found > 0u && next + found > params.candidate_capacity) {
    atomicStore(&statistics[kStatRolledBack], 1u);
    return params.candidate_capacity;
  }
  return next;
}

// Which of the workgroup's triangles a box meets, as bits: part by part, since it meets few of them.
fn triangles_met(box : Box) -> vec2u {
  return vec2u(half_met(box, 0u), half_met(box, kParts / 2u));
}
fn half_met(box : Box, first : u32) -> u32 {
  var hits = 0u;
  for (var part = 0u; part < kParts / 2u; part++) {
    let k = first + part;
    if (overlap(box, Box(part_lows[k], part_highs[k]))) { hits |= part_met(box, kOfPart * k) << (kOfPart * part); }
  }
  return hits;
}
// All at once, since each waits for workgroup memory.
fn part_met(box : Box, first : u32) -> u32 {
  return own_met(box, first) | (own_met(box, first + 1u) << 1u) | (own_met(box, first + 2u) << 2u) |
         (own_met(box, first + 3u) << 3u) | (own_met(box, first + 4u) << 4u) | (own_met(box, first + 5u) << 5u) |
         (own_met(box, first + 6u) << 6u) | (own_met(box, first + 7u) << 7u);
}
fn own_met(box : Box, k : u32) -> u32 { return select(0u, 1u, overlap(box, Box(lows[k], highs[k]))); }

// Of 32 of the workgroup's triangles from this one on, those that a later cloth triangle meets, and with which it lies
// in no open patch.
fn candidates_of(hits : u32, first : u32, later : u32, corners_of_later : vec3u) -> u32 {
  let earlier = min(32u, max(later, first) - first);
  var left = hits & select((1u << earlier) - 1u, 0xffffffffu, earlier == 32u);
  var beside = 0u;  // those that share an edge
  let cells = cells_of_triangle(later);
  for (var bits = left; bits != 0u; bits &= bits - 1u) {
    let k = firstTrailingBit(bits);
    if (in_patch(own_patches[(first + k) % kOwn], own_cells[(first + k) % kOwn], cells)) {
      left &= ~(1u << k);
      continue;
    }
    let shared_corners = shares(own_corners[(first + k) % kOwn], corners_of_later);
    beside |= select(0u, 1u << k, countOneBits(shared_corners) == 2u);
  }
  if (beside == 0u) { return left; }
  let sheet = sheet_of(corners_of_later);
  for (; beside != 0u; beside &= beside - 1u) {
    let k = firstTrailingBit(beside);
    if (lie_flat(sheet, sheet_of(own_corners[(first + k) % kOwn]))) { left &= ~(1u << k); }
  }
  return left;
}
fn list_candidates(kind : u32, first : u32, listed : u32, other : u32, place : u32) {
  var next = place;
  for (var hits = listed; hits != 0u && next < params.candidate_capacity; hits &= hits - 1u) {
    candidates[next] = vec2u((first + firstTrailingBit(hits)) | (kind << kKindShift), other);
    next++;
  }
}

// Lists the candidates among the triangles that a walk has met. All invocations of a workgroup, whose first triangle is
// `first_own`, call it; each takes a triangle met and asks which of theirs it meets.
fn meet_triangles(tree : Tree, held : u32, first_own : u32, thread : u32) {
  for (var first = 0u; first < held; first += kWalkers) {
    var hits = vec2u(0u);
    var place = 0u;
    if (first + thread < held) {
      place = met[first + thread];
      hits = triangles_met(box_in(tree, place));
      if (tree.kind == kNearCloth && any(hits != vec2u(0u))) {
        let corners_of_later = triangles[place].xyz;
        hits = vec2u(candidates_of(hits.x, first_own, place, corners_of_later),
                     candidates_of(hits.y, first_own + 32u, place, corners_of_later));
      }
    }
    let next = allocate_candidates(thread, countOneBits(hits.x) + countOneBits(hits.y));
    list_candidates(tree.kind, first_own, hits.x, place, next);
    list_candidates(tree.kind, first_own + 32u, hits.y, place, next + countOneBits(hits.x));
  }
}

// Meets the triangles of a tree.
fn meet_tree(tree : Tree, box : Box, first_own : u32, thread : u32) {
  unite_parts(box, thread);
  begin_walk(tree, thread);
  loop {
    let sizes = workgroupUniformLoad(&walk_sizes);
    if (sizes.x == 0u && sizes.y == 0u) { break; }
    if (sizes.x == 0u || sizes.y > kMetRoom - kMostOfLeaf * kWalkers) {
      meet_triangles(tree, sizes.y, first_own, thread);
      if (thread == 0u) {
        walk_sizes = vec2u(sizes.x, 0u);
        atomicStore(&met_count, 0u);
      }
    } else {
      walk_on(tree, sizes.x, thread);
    }
  }
}

// A point in the space of a collider: the transpose of its rotation.
fn local(collider : u32, p : vec3f) -> vec3f {
  let row = params.first_row + 4u * collider;
  let rx = points[row];
  let ry = points[row + 1u];
  let rz = points[row + 2u];
  let d = p - vec3f(rx.w, ry.w, rz.w);
  return d.x * rx.xyz + d.y * ry.xyz + d.z * rz.xyz;
}

// The box of the triangle in the space of a rigid mesh.
fn local_box(collider : u32) -> Box {
  return united(box_of(local(collider, a), local(collider, b), local(collider, c)),
                box_of(local(collider, a + ahead_a), local(collider, b + ahead_b), local(collider, c + ahead_c)));
}

// Whether a collider without triangles is near.
fn shape_near(collider : vec4u, radius : f32) -> bool {
  let wide = grown(own_box, radius);
  if (collider.x == kColliderSphere) {
    let ball = points[collider.y];
    return overlap(grown(Box(ball.xyz, ball.xyz), ball.w), wide);
  }
  if (collider.x == kColliderCapsule) {
    let start = points[collider.y];
    let far = points[collider.y + 2u];
    let bounds = grown(Box(min(start.xyz, far.xyz), max(start.xyz, far.xyz)), start.w);
    return overlap(bounds, wide);
  }
  if (collider.x == kColliderPlane) {
    let q = points[collider.y].xyz;
    let n = points[collider.y + 1u].xyz;
    let lowest = select(own_box.high, own_box.low, n > vec3f(0.0));
    return dot(lowest - q, n) < radius;
  }
  return false;
}

fn meet_shapes(radius : f32, works : bool, thread : u32) {
  for (var first = 0u; first < params.collider_count; first += 32u) {
    var hits = 0u;
    for (var k = 0u; works && k < min(32u, params.collider_count - first); k++) {
      hits |= select(0u, 1u << k, shape_near(colliders.list[first + k], radius));
    }
    var next = allocate_candidates(thread, countOneBits(hits));
    while (hits != 0u && next < params.candidate_capacity) {
      let collider = colliders.list[first + firstTrailingBit(hits)];
      hits &= hits - 1u;
      candidates[next] = vec2u(own | ((collider.x + kNearSphere - kColliderSphere) << kKindShift), collider.y);
      next++;
    }
  }
}

fn read_own() {
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
}

fn if_works(works : bool, box : Box) -> Box {
  if (works) { return box; }
  return empty_box();
}

@compute @workgroup_size(kWalkers)
fn find_candidates(@builtin(workgroup_id) group : vec3u, @builtin(num_workgroups) groups : vec3u,
                   @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) { due = atomicLoad(&statistics[kStatDue]); }
  if (workgroupUniformLoad(&due) == 0u) { return; }
  let first = kOwn * flat_group(group);
  own = first + thread;
  var works = thread < kOwn && own < params.triangle_count;
  if (works) {
    read_own();
    own_corners[thread] = corners;
    own_cells[thread] = cells_of_triangle(own);
    own_patches[thread] = open_patches(own_cells[thread]);
    works = is_finite(a) && is_finite(b) && is_finite(c);
  }
  find_patches(first, thread);
  let radius = params.thickness + own_slack + bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  // The cloths' tree, then those of colliders, by one call: compilers expand each, and three took a software adapter
  // 15 s to compile.
  for (var k = group.z; k <= params.collider_count; k += groups.z) {
    var tree = Tree(kNearCloth, 0u, 0u, params.triangle_count, first + 1u);
    var box = grown(own_box, params.self_thickness + own_slack);
    if (k == 0u && params.self_contact != 1u) { continue; }
    if (k > 0u) {
      let collider = colliders.list[k - 1u];
      let rigid = collider.x == kColliderTree;
      if (!rigid && collider.x != kColliderImplicit) { continue; }
      tree = Tree(select(kNearDeforming, kNearRigid, rigid), collider.y, collider.z, select(collider.w, 0u, rigid), 0u);
      box = grown(own_box, radius);
      if (rigid) { box = grown(local_box(collider.w), radius); }
    }
    meet_tree(tree, if_works(works, box), first, thread);
  }
  if (group.z == 0u) { meet_shapes(radius, works, thread); }
}
