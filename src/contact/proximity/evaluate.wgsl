// Measures every pair that has a record at the start of a substep, decides which act, and with which impulses they
// begin: equations (1), (1c), (3a) of docs/contact.md. Grid-stride loop over the records. A pair's vertices count it.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/hash_pair.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/crossing.wgsl"
#include "contact/proximity/parting.wgsl"
#include "contact/proximity/relative_velocity.wgsl"
#include "contact/proximity/cones.wgsl"
#include "contact/proximity/rigid_sums.wgsl"
#include "contact/proximity/planes.wgsl"
#include "contact/proximity/sides.wgsl"
#include "contact/proximity/turned_plane.wgsl"
#include "contact/proximity/sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // vertex_count      m/s
@group(0) @binding(3) var<storage, read>       points          : array<vec4f>; // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> statistics      : array<atomic<u32>>;
@group(0) @binding(7) var<storage, read>       rings           : array<u32>;   // feature_rings.hpp
@group(0) @binding(8) var<storage, read_write> rigid           : array<atomic<u32>>;

const kShapeWords = 2u;  // of a point, behind the ends: collider_set.hpp
const kLeastNear = 1e-9;  // m: of cloth that is to meet a body, from twice the thickness away
const kTouch = 0.01;  // of the thickness: a nearer feature has no side of its own

var<workgroup> records : u32;
var<workgroup> crossings : u32;  // that the last search has found

fn velocity_of(vertex : u32) -> vec3f { return predicted[vertex].xyz; }
fn end_of_way(vertex : u32) -> vec3f { return previous[vertex].xyz + step.time.dt * predicted[vertex].xyz; }

// The speed of a solid side in the direction of the other.
fn solid_speed(ids : vec4u, first : u32, end : u32, w : vec4f, toward : vec3f, surface : vec3f) -> f32 {
  var speed = -dot(toward, surface);  // of a collider: the surface's part has its sign in the pair
  for (var role = first; role < end; role++) {
    if (!is_collider(ids[role])) { speed += abs(w[role]) * dot(toward, velocity_of(ids[role] & kIdBits)); }
  }
  return speed;
}

// The rigid body of a pair, if it has one.
struct Body {
  exists : bool,
  collider : u32,
  words : u32,  // of `rigid`, its first
  arm : vec3f,  // from its centre, where its way ends, to the pair's place on cloth, m
}
fn body_of(ids : vec4u, w : vec4f) -> Body {
  var body = Body(false, 0u, 0u, vec3f(0.0));
  if (!kRigid || is_crossing(ids) || is_plane_pair(ids)) { return body; }
  let point = collider_of(ids);
  if (!is_collider(point)) { return body; }
  body.collider = u32(points[2u * step.contact.point_count + kShapeWords * (point & kIdBits) + 1u].w);
  body.words = kRigidWords * body.collider;
  body.exists = rigid_number(body.words + kRigidInverseMass) > 0.0;
  var place = vec3f(0.0);
  for (var role = 0u; role < 4u; role++) {
    if (!is_collider(ids[role])) { place += abs(w[role]) * previous[ids[role] & kIdBits].xyz; }
  }
  body.arm = place - rigid_vector(body.words + kRigidNext);
  return body;
}

// Equation (3a): the force of the substep before, less what takes back the speed at which the features part.
fn first_force(ids : vec4u, w : vec4f, n : vec3f, kept : vec3f, friction : f32, speed : f32, body : Body) -> vec3f {
  var mobility = 0.0;  // were the pair alone, 1/kg
  for (var role = 0u; role < role_count(ids); role++) {
    if (!is_collider(ids[role])) { mobility += w[role] * w[role] * previous[ids[role] & kIdBits].w; }
  }
  if (body.exists) {
    mobility += dot(n, body_mobility(body.words, inverse_inertia(body.words), body.arm, n));
  }
  if (mobility <= 0.0) { return vec3f(0.0); }
  let parting = max(0.0, speed - speed_of_load());
  return within_cone(kept - parting / (mobility * step.time.dt) * n, n, friction);
}

// How much the load brings the sides together in the substep, m/s.
fn speed_by_load(ids : vec4u, w : vec4f, n : vec3f, body : Body) -> f32 {
  var loaded = select(0.0, body_side(ids), body.exists);  // a body falls as cloth does
  for (var role = 0u; role < role_count(ids); role++) {
    if (!is_collider(ids[role]) && previous[ids[role] & kIdBits].w > 0.0) { loaded += w[role]; }
  }
  return -loaded * step.time.dt * dot(n, step.air.acceleration.xyz);
}

// Equation (3): the least normal velocity that a pair may end with.
fn least_speed(ids : vec4u, w : vec4f, n : vec3f, gap : f32, thickness : f32, speed : f32, body : Body) -> f32 {
  let dt = step.time.dt;
  let e = step.contact.restitution;
  let bounces = (e > 0.0) & (-speed > speed_of_load()) & (gap + dt * speed < thickness);
  let least = -max(0.0, gap - thickness) / dt;
  if (!bounces) { return least; }
  let toward = speed_by_load(ids, w, n, body);
  return max(least, e * (-speed - toward) - toward);
}

// Whether the collider of the pair, if it has one, is a closed mesh.
fn is_of_closed_mesh(ids : vec4u) -> bool {
  return min(min(start_of(ids.x).w, start_of(ids.y).w), start_of(ids.z).w) < 0.0;
}

override kOwnPairs : bool = false;  // as in press.wgsl
// Whether the solver has answered the pair: of a vertex that it holds by all that presses it (a velocity's w is -1), or
// where only its own pairs do, of such vertices alone; where it lay before the substep, so that it was among that.
fn is_held(ids : vec4u, w : vec4f, gap : f32, thickness : f32) -> bool {
  var any_held = false;
  var all_held = true;
  for (var role = 0u; role < role_count(ids); role++) {
    if (is_collider(ids[role]) || w[role] == 0.0) { continue; }
    let held = predicted[ids[role] & kIdBits].w == -1.0;
    any_held |= held;
    all_held &= held;
  }
  return any_held && (all_held || !kOwnPairs) && gap < kContactTouching * thickness;
}

@compute @workgroup_size(kWorkgroupSize)
fn evaluate(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
            @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    if (id.x == 0u) { atomicStore(&statistics[kStatFarWays], 0u); }
    records = select(atomicLoad(&statistics[kStatNear]), 0u, atomicLoad(&statistics[kStatRolledBack]) != 0u);
    crossings = atomicLoad(&statistics[kStatCrossingsLeft]);
  }
  let count = workgroupUniformLoad(&records);
  let tangled = workgroupUniformLoad(&crossings) != 0u;
  var hits = 0u;
  var pressed = 0;
  var hash = 0u;
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let ids = contacts[number].ids;
    let is_self = is_self_pair(ids);
    var measured : Measured;
    var friction = contacts[number].surface.w;
    var untangles = false;
    var on_face = false;  // of a closed mesh: equation (1c)
    if (is_crossing(ids)) {
      let p = start_of(ids.x).xyz;
      let q = start_of(contacts[number].other_end).xyz;
      let p1 = start_of(ids.y).xyz;
      let p2 = start_of(ids.z).xyz;
      let p3 = start_of(ids.w).xyz;
      let at = crossing_place(p, q, p1, p2, p3);
      let way = contacts[number].normal;
      measured = Measured(at.x, at.y, crosses(p, q, p1, p2, p3), way.xyz, way.w, 0.0, 0.0);
      untangles = true;
    } else {
      measured = measure(ids, contacts[number].other_end);
      let distance = measured.gap + measured.radius;
      let touches = !is_shape_pair(ids) && distance < kTouch * step.contact.thickness && is_of_closed_mesh(ids);
      if (touches || (tangled && measured.radius == 0.0 && is_tangled(ids, is_self))) {
        // The outside of a closed mesh is known. All other cases are left to the crossings.
        let p0 = start_of(ids.x).xyz;
        let p1 = start_of(ids.y);
        let normal = cross(start_of(ids.z).xyz - p1.xyz, start_of(ids.w).xyz - p1.xyz);
        let size = length(normal);
        let from_face = !is_self && !is_edge_pair(ids) && p1.w < 0.0 && is_collider(ids.y) && size > 0.0;
        let outside = dot(measured.normal, normal) >= 0.0;
        let over = measured.s > 0.0 && measured.t > 0.0 && measured.s + measured.t < 1.0;
        if (from_face && touches) {
          let n = normal / size;
          measured = Measured(measured.s, measured.t, true, n, dot(n, p0 - p1.xyz), 0.0, dot(n, p0));
          on_face = true;
        } else if (from_face && !outside && over) {
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
    let thickness = contacts[number].thickness;
    let w = weights_of(ids, measured.s, measured.t);
    let n = measured.normal;
    let gap = measured.gap;
    var r = relative_velocity(ids, w, measured);
    let body = body_of(ids, w);
    if (body.exists) { r.surface = body_side(ids) * free_velocity(body.words, body.arm); }
    let speed = dot(n, r.velocity + r.surface);
    let is_near = gap + min(step.time.dt * speed, 0.0) < kContactTouching * thickness;
    let solved = contacts[number].held == kSolved && !untangles;
    var acts = measured.counts && is_near;
    if (acts && !untangles && !on_face) { acts = lies_in_cones(ids, measured); }
    acts = acts || solved;
    let urgency = urgency_of(gap + min(step.time.dt * speed, 0.0), thickness);
    let solid = solid_side(ids);
    var contact = contacts[number];
    contact.place = vec4f(measured.s, measured.t, measured.place_a, 0.0);
    contact.solid = select(solid, kUntangles, untangles);
    contact.solid_speed = 0.0;
    var across = n;  // the plane before a solid side
    if (contact.solid == 1u || contact.solid == 2u) {
      let side = solid_side_of(ids, contact.solid);
      if (!acts && !is_self && gap > 0.0) { across = turned_normal(ids, measured, thickness); }
      contact.place.w = reach_of(ids, side.first, side.last, side.toward, across, measured.radius);
      contact.solid_speed = solid_speed(ids, side.first, side.last, w, side.toward * across, r.surface);
    }
    if (!is_self) { friction = friction_of(ids, friction); }
    contact.normal = vec4f(across, gap);
    contact.surface = vec4f(r.surface, friction);
    contact.urgency = select(0.0, f32(urgency), acts);
    let held = acts && !untangles && !is_self && is_held(ids, w, gap, thickness);
    contact.held = select(select(0u, 1u, held), kSolved, solved);
    var force = vec3f(0.0);
    if (solved) {
      force = contact.force.xyz;
    } else if (acts && !untangles) {
      force = first_force(ids, w, n, contact.force.xyz, friction, speed, body);
    }
    contact.force = vec4f(force, least_speed(ids, w, n, gap, thickness, speed, body));
    contact.begun = dot(n, force);
    let is_kept = any(force != vec3f(0.0)) && !solved;
    let holds = gap > 0.0 && contact.solid != 0u;  // has planes that what is not solid must not pass
    contact.near = select(0u, 1u, is_near || holds);
    if (body.exists) {
      contacts[number].other_end = sides_with_body(contact.other_end, body.collider);
      if (acts) { atomicAdd(&rigid[body.words + kRigidShares], urgency); }
      if (acts && !untangles && lifts(rigid_vector(body.words + kRigidLift), body_side(ids) * n)) {
        atomicMax(&rigid[body.words + kRigidNear], bitcast<u32>(max(2.0 * thickness - gap, kLeastNear)));
      }
      if (is_kept) { add_to_body(body.words, kRigidSums, body.arm, body_side(ids) * step.time.dt * force); }
    }
    contacts[number].normal = contact.normal;
    contacts[number].place = contact.place;
    contacts[number].surface = contact.surface;
    contacts[number].force = contact.force;
    contacts[number].urgency = contact.urgency;
    contacts[number].solid = contact.solid;
    contacts[number].solid_speed = contact.solid_speed;
    contacts[number].begun = contact.begun;
    contacts[number].held = contact.held;
    contacts[number].near = contact.near;
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role]) || contact.near == 0u) { continue; }
      let vertex = ids[role] & kIdBits;
      if (acts) {
        atomicAdd(&vertex_contacts[kVertexWords * vertex + kShareWord], share_units(f32(urgency), w[role]));
      }
      if (acts && is_of_two_systems(contact) && w[role] != 0.0) {
        atomicOr(&vertex_contacts[kVertexWords * vertex + kHeldWord], kBesideCloth);
      }
      if (acts && !is_self && w[role] != 0.0 && gap + step.time.dt * speed < kStruckNear * thickness) {
        atomicOr(&vertex_contacts[kVertexWords * vertex + kHeldWord], kStruck);
      }
      if (is_kept) {
        add_units(kVertexWords * vertex + kFirstWord, kSpeedUnits,
                  previous[vertex].w * w[role] * step.time.dt * force);
      }
      var tight = 0.0;
      if (holds) {
        let held = atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]);
        if ((held & kBesideSolid) == 0u) {
          atomicOr(&vertex_contacts[kVertexWords * vertex + kHeldWord], kBesideSolid);
        }
        tight = free_way() + beyond(contact, role, previous[vertex].xyz);
      }
      if (untangles && acts && !is_self) { tight = kInBody; }
      if (tight > 0.0) { atomicMax(&vertex_contacts[kVertexWords * vertex + kTightWord], bitcast<u32>(tight)); }
    }
    if (acts && is_self && !untangles) {
      pressed += select(0, kPressedOften, gap < kPressedGap * thickness) - 1;
    }
    if (acts) {
      hits++;
      hash += hash_pair(hash_pair(ids.x, ids.y), hash_pair(ids.z, ids.w));
    }
  }
  if (hits > 0u) {
    atomicAdd(&statistics[kStatContacts], hits);
    atomicAdd(&statistics[kStatContactHash], hash);
    atomicAdd(&statistics[kStatPressed], bitcast<u32>(pressed));
  }
}
