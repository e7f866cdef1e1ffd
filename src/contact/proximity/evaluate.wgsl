// Measures every listed pair at the start of a substep, and decides which act: equation (1) of docs/contact.md.
// Grid-stride loop over the pairs. A pair's vertices count it, and their entries bear its marks.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/hash_pair.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/crossing.wgsl"
#include "contact/proximity/measure.wgsl"
#include "contact/proximity/planes.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // 2 * vertex_count  m/s, then m
@group(0) @binding(3) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(5) var<storage, read_write> entries         : array<u32>;
@group(0) @binding(6) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;

const kTouch = 0.01;  // of the thickness: a nearer feature has no side of its own

var<workgroup> listed : u32;
var<workgroup> crossings : u32;  // that the last search has found

fn velocity_of(vertex : u32) -> vec3f { return predicted[vertex].xyz; }

// Whether roles from `first` to before `end` are a collider's or kinematic.
fn is_solid(ids : vec4u, first : u32, end : u32) -> bool {
  var solid = true;
  for (var role = first; role < end; role++) {
    solid = solid && (is_collider(ids[role]) || previous[ids[role] & kIdBits].w == 0.0);
  }
  return solid;
}

// How far along n a solid side will be at the end of the substep, in the direction of the other.
fn reach_of(ids : vec4u, first : u32, end : u32, sign : f32, n : vec3f, radius : f32) -> f32 {
  var reach = -3e38;
  for (var role = first; role < end; role++) {
    let id = ids[role];
    var place : vec3f;
    if (is_collider(id)) {
      place = end_of(id).xyz;
    } else {
      place = previous[id & kIdBits].xyz + step.time.dt * predicted[id & kIdBits].xyz;
    }
    reach = max(reach, sign * dot(n, place));
  }
  return sign * (reach + radius);
}

// Marks of the last search at the cloth vertices from role `first` to before `end`: kTangledCloth, kTangledMesh.
fn tangles_of(ids : vec4u, first : u32, end : u32) -> u32 {
  var marks = 0u;
  for (var role = first; role < end; role++) {
    if (!is_collider(ids[role])) {
      marks |= atomicLoad(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kCursorWord]);
    }
  }
  return marks & ~kCursorBits;
}

// Whether the collider of the pair, if it has one, is a closed mesh.
fn is_of_closed_mesh(ids : vec4u) -> bool {
  return min(min(start_of(ids.x).w, start_of(ids.y).w), start_of(ids.z).w) < 0.0;
}

// Whether both features belong to a crossing, so that either may be on its wrong side.
fn is_tangled(ids : vec4u, is_self : bool) -> bool {
  if (is_plane_pair(ids)) { return false; }
  let of_a = tangles_of(ids, 0u, roles_of_a(ids));
  let of_b = tangles_of(ids, roles_of_a(ids), 4u);
  if (is_self) { return (of_a & of_b & kTangledCloth) != 0u; }
  return ((of_a | of_b) & kTangledMesh) != 0u;
}

@compute @workgroup_size(kWorkgroupSize)
fn evaluate(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
            @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    listed = select(atomicLoad(&statistics[kStatPairs]), 0u, atomicLoad(&statistics[kStatRolledBack]) != 0u);
    crossings = atomicLoad(&statistics[kStatCrossingsLeft]);
  }
  let count = workgroupUniformLoad(&listed);
  let free = free_way();
  let tangled = workgroupUniformLoad(&crossings) != 0u;
  var hits = 0u;
  var hash = 0u;
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    let is_self = is_self_pair(ids);
    var measured : Measured;
    var friction = contacts[pair].surface.w;
    var untangles = false;
    if (is_crossing(ids)) {
      let p = start_of(ids.x).xyz;
      let q = start_of(contacts[pair].other_end).xyz;
      let p1 = start_of(ids.y).xyz;
      let p2 = start_of(ids.z).xyz;
      let p3 = start_of(ids.w).xyz;
      let at = crossing_place(p, q, p1, p2, p3);
      let way = contacts[pair].normal;
      measured = Measured(at.x, at.y, crosses(p, q, p1, p2, p3), way.xyz, way.w, 0.0, 0.0);
      untangles = true;
    } else {
      measured = measure(ids);
      let distance = measured.gap + measured.radius;
      let touches = !is_plane_pair(ids) && distance < kTouch * step.contact.thickness && is_of_closed_mesh(ids);
      if (touches || (tangled && measured.radius == 0.0 && is_tangled(ids, is_self))) {
        // The outside of a closed mesh is known. All other cases are left to the crossings.
        let p1 = start_of(ids.y);
        let normal = cross(start_of(ids.z).xyz - p1.xyz, start_of(ids.w).xyz - p1.xyz);
        let size = length(normal);
        let from_face = !is_self && !is_edge_pair(ids) && p1.w < 0.0 && is_collider(ids.y) && size > 0.0;
        let outside = dot(measured.normal, normal) >= 0.0 && !touches;
        let over = measured.s > 0.0 && measured.t > 0.0 && measured.s + measured.t < 1.0;
        if (from_face && !outside && (over || touches)) {
          measured.counts = distance < step.contact.thickness;
          measured.normal = normal / size;
          measured.gap = -1.0;
          untangles = true;
        } else if (!from_face || !outside) {
          measured.counts = false;
          measured.gap = 0.0;
        }
      }
    }
    let n = measured.normal;
    let gap = measured.gap;
    let w = weights_of(ids, measured.s, measured.t);
    let r = relative_velocity(ids, w, measured);
    let thickness = select(step.contact.thickness, step.contact.self_thickness, is_self);
    let speed = dot(n, r.velocity + r.surface);
    let is_near = gap + min(step.time.dt * speed, 0.0) < kContactTouching * thickness;
    let acts = measured.counts && is_near;
    let urgency = urgency_of(gap + min(step.time.dt * speed, 0.0), thickness);
    let first_b = roles_of_a(ids);
    let end_b = role_count(ids);
    var reach = 0.0;
    var solid = 0u;
    if (untangles) {
      solid = kUntangles;
    } else if (is_solid(ids, first_b, end_b)) {
      solid = 2u;
      reach = reach_of(ids, first_b, end_b, 1.0, n, measured.radius);
    } else if (is_solid(ids, 0u, first_b)) {
      solid = 1u;
      reach = reach_of(ids, 0u, first_b, -1.0, n, measured.radius);
    }
    if (!is_self) { friction = friction_of(ids, friction); }
    var contact = contacts[pair];
    contact.normal = vec4f(n, gap);
    contact.place = vec4f(measured.s, measured.t, measured.place_a, reach);
    contact.surface = vec4f(r.surface, friction);
    contact.urgency = select(0.0, f32(urgency), acts);
    contact.solid = solid;
    let near_flag = select(0u, kEntryNear, is_near);
    let is_other = near_flag != contact.near;  // most stay as they were
    contact.near = near_flag;
    contacts[pair].normal = contact.normal;
    contacts[pair].place = contact.place;
    contacts[pair].surface = contact.surface;
    contacts[pair].urgency = contact.urgency;
    contacts[pair].solid = contact.solid;
    contacts[pair].near = contact.near;
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role])) { continue; }
      if (is_other) { entries[contact.slots[role]] = kEntryPair * pair + near_flag + role; }
      if (!is_near) { continue; }
      let words = kVertexWords * (ids[role] & kIdBits);
      if (acts && w[role] != 0.0) { atomicAdd(&vertex_contacts[words + kUrgencyWord], urgency); }
      var tight = 0.0;
      if (gap > 0.0) { tight = free + beyond(contact, role, previous[ids[role] & kIdBits].xyz); }
      if (untangles && acts && !is_self) { tight = kInBody; }
      if (tight > 0.0) { atomicMax(&vertex_contacts[words + kTightWord], bitcast<u32>(tight)); }
    }
    if (acts) {
      hits++;
      hash += hash_pair(hash_pair(ids.x, ids.y), hash_pair(ids.z, ids.w));
    }
  }
  if (hits > 0u) {
    atomicAdd(&statistics[kStatContacts], hits);
    atomicAdd(&statistics[kStatContactHash], hash);
  }
}
