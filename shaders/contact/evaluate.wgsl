// Measures every listed pair at the start of a substep, and says which act: equation (1) of docs/contact.md. An invocation takes
// every so-manieth pair. Its vertices count it, and their entries bear its marks.
#include "shared/index.wgsl"
#include "shared/step.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
#include "contact/closest.wgsl"
#include "contact/crossing.wgsl"
#include "contact/planes.wgsl"
//                                                                                     elements              unit
@group(0) @binding(0) var<uniform>             step            : StepParams;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>;        // vertex_count          m
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>;        // 2 * vertex_count      m/s, then m
@group(0) @binding(3) var<storage, read>       points          : array<vec4f>;        // of colliders: contact/move_points.wgsl
@group(0) @binding(4) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(5) var<storage, read_write> entries         : array<u32>;
@group(0) @binding(6) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;

const kTouch = 0.01;  // of the thickness: what is nearer has no side of its own

var<workgroup> listed : u32;
var<workgroup> crossings : u32;  // that the last search has found

fn start_of(id : u32) -> vec4f {
  if (is_collider(id)) { return points[id & kIdBits]; }
  return previous[id & kIdBits];
}
fn end_of(id : u32) -> vec4f { return points[step.point_count + (id & kIdBits)]; }

struct Relative {
  velocity : vec3f,  // what cloth brings to u, m/s
  surface : vec3f,   // what the collider brings, m/s
}

fn relative_velocity(ids : vec4u, w : vec4f, n : vec3f, radius : f32) -> Relative {
  var r = Relative(vec3f(0.0), vec3f(0.0));
  for (var role = 0u; role < role_count(ids); role++) {
    let id = ids[role];
    if (is_collider(id)) {
      r.surface += w[role] * ((end_of(id).xyz - start_of(id).xyz) / step.dt);
    } else {
      r.velocity += w[role] * predicted[id & kIdBits].xyz;
    }
  }
  if (radius > 0.0) {  // the surface of a ball that turns: its spin is the point after its centre
    let on_a = is_collider(ids.x);
    let id = select(ids.z, ids.x, on_a) & kIdBits;
    let arm = select(radius, -radius, on_a) * n;
    r.surface += select(-1.0, 1.0, on_a) * cross(points[id + 1u].xyz, arm);
  }
  return r;
}

// Whether roles from `first` to before `end` are a collider's or held by the scene.
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
      place = previous[id & kIdBits].xyz + step.dt * predicted[id & kIdBits].xyz;
    }
    reach = max(reach, sign * dot(n, place));
  }
  return sign * (reach + radius);
}

// What the last search has found at the cloth vertices from role `first` to before `end`: kTangledCloth, kTangledMesh.
fn tangles_of(ids : vec4u, first : u32, end : u32) -> u32 {
  var marks = 0u;
  for (var role = first; role < end; role++) {
    if (!is_collider(ids[role])) { marks |= atomicLoad(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kCursorWord]); }
  }
  return marks & ~kCursorBits;
}

// Whether both features are of what passes through each other, so that either may be on its wrong side.
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
    listed = select(atomicLoad(&statistics[kStatPairs]), 0u, atomicLoad(&statistics[kStatHeld]) != 0u);
    crossings = atomicLoad(&statistics[kStatFound]);
  }
  let count = workgroupUniformLoad(&listed);
  let free = free_way();
  let tangled = workgroupUniformLoad(&crossings) != 0u;
  var hits = 0u;
  var hash = 0u;
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    let is_self = is_self_pair(ids);
    let p0 = start_of(ids.x);
    let p1 = start_of(ids.y);
    var near : Closest;
    var n : vec3f;
    var gap : f32;
    var place_a : f32;  // n·p_A
    var radius = 0.0;
    var friction = contacts[pair].surface.w;
    var untangles = false;
    if (is_crossing(ids)) {
      let q = start_of(contacts[pair].other_end).xyz;
      let p2 = start_of(ids.z).xyz;
      let p3 = start_of(ids.w).xyz;
      let at = crossing_place(p0.xyz, q, p1.xyz, p2, p3);
      near.inside = crosses(p0.xyz, q, p1.xyz, p2, p3);
      near.s = at.x;
      near.t = at.y;
      n = contacts[pair].normal.xyz;
      gap = contacts[pair].normal.w;
      untangles = true;
    } else if (is_plane_pair(ids)) {
      n = points[(ids.y & kIdBits) + 1u].xyz;
      gap = dot(n, p0.xyz - p1.xyz);
      place_a = dot(n, p0.xyz);
      near.inside = true;
      near.s = 0.0;
      near.t = 0.0;
    } else {
      let p2 = start_of(ids.z);
      let p3 = start_of(ids.w);
      if (is_edge_pair(ids)) {
        near = closest_on_edges(p0.xyz, p1.xyz, p2.xyz, p3.xyz);
        if (is_collider(ids.z)) { radius = max(p2.w, 0.0); }
        place_a = 0.0;
      } else {
        near = closest_on_triangle(p0.xyz, p1.xyz, p2.xyz, p3.xyz);
        if (is_collider(ids.x)) { radius = max(p0.w, 0.0); }
      }
      let distance = length(near.apart);
      n = select(vec3f(0.0, 1.0, 0.0), near.apart / distance, distance > 0.0);
      gap = distance - radius;
      place_a = dot(n, p0.xyz);
      if (is_edge_pair(ids)) { place_a = dot(n, p0.xyz + near.s * (p1.xyz - p0.xyz)); }
      let touches = distance < kTouch * step.thickness && min(min(p0.w, p1.w), p2.w) < 0.0;  // a closed mesh
      if (touches || (tangled && radius == 0.0 && is_tangled(ids, is_self))) {
        // Of a closed mesh the outside is known. All else is left to what crosses.
        let normal = cross(p2.xyz - p1.xyz, p3.xyz - p1.xyz);
        let size = length(normal);
        let from_face = !is_self && !is_edge_pair(ids) && p1.w < 0.0 && is_collider(ids.y) && size > 0.0;
        let outside = dot(near.apart, normal) >= 0.0 && !touches;
        let over = near.s > 0.0 && near.t > 0.0 && near.s + near.t < 1.0;
        if (from_face && !outside && (over || touches)) {
          near.inside = distance < step.thickness;
          n = normal / size;
          gap = -1.0;
          untangles = true;
        } else if (!from_face || !outside) {
          near.inside = false;
          gap = 0.0;
        }
      }
    }
    let w = weights_of(ids, near.s, near.t);
    let r = relative_velocity(ids, w, n, radius);
    let thickness = select(step.thickness, step.self_thickness, is_self);
    let speed = dot(n, r.velocity + r.surface);
    let counts = near.inside || radius > 0.0;
    let is_near = gap + min(step.dt * speed, 0.0) < kTouching * thickness;
    let acts = counts && is_near;
    let urgency = urgency_of(gap + min(step.dt * speed, 0.0), thickness);
    let first_b = roles_of_a(ids);
    let end_b = role_count(ids);
    var reach = 0.0;
    var solid = 0u;
    if (untangles) {
      solid = kUntangles;
    } else if (is_solid(ids, first_b, end_b)) {
      solid = 2u;
      reach = reach_of(ids, first_b, end_b, 1.0, n, radius);
    } else if (is_solid(ids, 0u, first_b)) {
      solid = 1u;
      reach = reach_of(ids, 0u, first_b, -1.0, n, radius);
    }
    if (!is_self) {
      let own = max(max(own_friction(ids.x), own_friction(ids.z)), own_friction(ids.y));
      if (own >= 0.0) { friction = own; }
    }
    var contact = contacts[pair];
    contact.normal = vec4f(n, gap);
    contact.place = vec4f(near.s, near.t, place_a, reach);
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
    atomicAdd(&statistics[kStatHits], hits);
    atomicAdd(&statistics[kStatHitHash], hash);
  }
}

// A collider's friction stands with its points at the end of the substep; negative: it has none of its own.
fn own_friction(id : u32) -> f32 {
  if (!is_collider(id)) { return -1.0; }
  return end_of(id).w;
}
