// Gives a record to each listed pair that has none yet and needs one: equation (1) of docs/contact.md holds, but for
// the cones; an obstacle's plane may be met on a way that is not far, or cloth is kinematic on one side; or an edge
// passes through a triangle there. A record lasts until the next search; in the substep of a search it has the force
// that the pair had before. Of all other pairs, most of a list, only the gap is noted. Grid-stride loop over the pairs.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/geometry.wgsl"
#include "contact/proximity/allocate.wgsl"
#include "contact/proximity/kept_forces.wgsl"
#include "contact/proximity/kept_list.wgsl"
#include "contact/proximity/planes.wgsl"
#include "contact/proximity/relative_velocity.wgsl"
#include "contact/proximity/sides.wgsl"
//                                                                                  elements           unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>;       // vertex_count   m
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>;       // vertex_count   m/s
@group(0) @binding(3) var<storage, read>       points          : array<vec4f>;       // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read_write> listed          : array<ListedPair>;
@group(0) @binding(5) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(6) var<storage, read_write> vertex_contacts : array<atomic<u32>>; // see state/contact.wgsl
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read>       kept            : array<u32>;         // kept_forces.wgsl

// Before a solver has predicted, by the velocities: of cloth with cloth alone, but in the first substep of a frame,
// where all that has a force is to keep it should there be another search.
override kEarly : bool = false;

var<workgroup> pairs : u32;
var<workgroup> crossings : u32;  // that the last search has found

fn velocity_of(vertex : u32) -> vec3f { return predicted[vertex].xyz; }

fn needs_record(pair : u32, tangled : bool) -> bool {
  let words = listed[pair].words;
  if ((words.x & kHasRecord) != 0u) { return false; }
  let ids = listed[pair].ids;
  if (is_crossing(ids)) { return true; }
  let thickness = bitcast<f32>(words.x);
  if (thickness == 0.0) { return false; }  // of one cloth, and touching at rest
  let is_self = is_self_pair(ids);
  if (kEarly && !is_self && step.contact.detect != kDetectAlways) { return false; }
  if ((is_self && solid_side(ids) != 0u) || (tangled && is_tangled(ids, is_self))) { return true; }
  let measured = measure(ids, words.w);
  listed[pair].words.z = bitcast<u32>(measured.gap);
  let r = relative_velocity(ids, weights_of(ids, measured.s, measured.t), measured);
  let way = step.time.dt * dot(measured.normal, r.velocity + r.surface);
  return measured.gap + min(way, 0.0) < kContactTouching * thickness ||
         (!is_self && measured.gap < (kFreeWay + kContactFloor) * thickness + travel_of(ids));
}

// How far the collider of a pair goes in the substep, m.
fn travel_of(ids : vec4u) -> f32 {
  var travel = 0.0;
  for (var role = 0u; role < role_count(ids); role++) {
    let id = ids[role];
    if (is_collider(id)) { travel = max(travel, distance(start_of(id).xyz, end_in_pair(ids, id))); }
  }
  return travel;
}

// Of the pair before the search, N; 0 if it did not act. w: 1 where that is of this substep, from the solver's matrix.
fn kept_force(ids : vec4u) -> vec4f {
  let list = kept_list();
  let room = kept[kKeptRoomWord];
  let first = first_place(room);
  let last = arrayLength(&kept) - first - 1u;
  var place = hash_of(ids) & last;
  loop {
    let number = kept[first + place];
    if (number == 0u) { break; }
    let word = kept_word(room, list, number - 1u);
    if (all(ids == vec4u(kept[word], kept[word + 1u], kept[word + 2u], kept[word + 3u]))) {
      return vec4f(bitcast<vec3f>(vec3u(kept[word + 4u], kept[word + 5u], kept[word + 6u])), f32(kept[word + 7u]));
    }
    place = (place + 1u) & last;
  }
  return vec4f(0.0);
}

fn begin_record(pair : u32, number : u32, searched : bool) {
  let ids = listed[pair].ids;
  let words = listed[pair].words;
  var record : Contact;
  record.ids = ids;
  if (is_crossing(ids)) {
    let way = bitcast<vec3f>(words.yzw);
    record.normal = vec4f(unit(way), -length(way));
    record.other_end = words.x | (ids.x & kColliderPoint);
    record.thickness = select(step.contact.thickness, step.contact.self_thickness, is_self_pair(ids));
  } else {
    record.thickness = bitcast<f32>(words.x);
    record.surface.w = bitcast<f32>(words.y);
    record.other_end = words.w;
    if (searched) {
      let had = kept_force(ids);
      record.force = vec4f(had.xyz, 0.0);
      record.held = select(0u, kSolved, had.w > 0.0);
    }
  }
  for (var role = 0u; role < role_count(ids); role++) {
    if (is_collider(ids[role])) { continue; }
    let word = kVertexWords * (ids[role] & kIdBits) + kLinkWord;
    record.next[role] = atomicExchange(&vertex_contacts[word], link_to(number, role));
  }
  contacts[number] = record;
  listed[pair].words.x = kHasRecord | number;
}

@compute @workgroup_size(kWorkgroupSize)
fn find_near(@builtin(workgroup_id) group : vec3u, @builtin(num_workgroups) groups : vec3u,
             @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    pairs = select(atomicLoad(&statistics[kStatPairs]), 0u, atomicLoad(&statistics[kStatRolledBack]) != 0u);
    crossings = atomicLoad(&statistics[kStatCrossingsLeft]);
  }
  let end = workgroupUniformLoad(&pairs);
  let tangled = workgroupUniformLoad(&crossings) != 0u;
  // No branch on the uniform, for which lavapipe would compile the kernel again in each substep.
  let is_due = !kEarly & (step.contact.detect != kDetectNo) & (atomicLoad(&statistics[kStatDue]) != 0u);
  let searched = (kStarts & (step.contact.detect == kDetectAlways)) | is_due;
  for (var first = group.x * kWorkgroupSize; first < end; first += groups.x * kWorkgroupSize) {
    let pair = first + thread;
    var is_near = false;
    if (pair < end) { is_near = needs_record(pair, tangled); }
    let number = allocate(thread, select(0u, 1u, is_near), kStatNear);
    let has_room = number < arrayLength(&contacts);
    if (is_near && has_room) { begin_record(pair, number, searched); }
    if (is_near && !has_room) { atomicStore(&statistics[kStatRolledBack], 1u); }
  }
}
