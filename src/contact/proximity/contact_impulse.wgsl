// An iteration of the pairs' impulses, all from the same velocities; the last one also pushes apart what is too near.
// Grid-stride loop over the records. Source: docs/contact.md, equations (2) to (5) and (7).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/press_sums.wgsl"
#include "contact/proximity/sums.wgsl"
#include "contact/proximity/rigid_sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // vertex_count      m/s
@group(0) @binding(3) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(5) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(6) var<storage, read_write> presses         : array<atomic<i32>>; // press_sums.wgsl
@group(0) @binding(7) var<storage, read_write> begun           : array<vec4f>; // contacts          N
@group(0) @binding(8) var<storage, read_write> rigid           : array<atomic<u32>>;
override kOwnPushTime : f32 = 1e9;   // s: for how long pairs of one cloth are pushed at most
override kBodyPushTime : f32 = 1e9;  // s: the same of bodies
override kPresses : u32 = 0;  // 1: a solver holds vertices at obstacles, and `presses` is that buffer
override kHeavy : u32 = 0;  // 1: heavy cloth may lie on light cloth, and `begun` has the forces before they went ahead
override kFirst : u32 = 0;  // of the substep's iterations, where kHeavy is 1
override kLast : u32 = 1;
override kWherePressed : u32 = 0;  // 1: only of cloth that is pressed
const kAhead = 0.5;        // of its change from one iteration to the next, the part by which a force goes ahead
const kHeavyAhead = 0.9;   // the same of all of a force

struct Answer {
  impulse : vec3f,   // how much the impulse on side A grows, N·s
  mobility : f32,    // W, 1/kg; 0: nothing can move
}

fn first_change(vertex : u32) -> vec3f {
  let word = kVertexWords * vertex + kFirstWord;
  return vec3f(vec3i(bitcast<i32>(atomicLoad(&vertex_contacts[word])),
                     bitcast<i32>(atomicLoad(&vertex_contacts[word + 1u])),
                     bitcast<i32>(atomicLoad(&vertex_contacts[word + 2u])))) / kSpeedUnits;
}

// Whether the pair is left to the solver, which has answered it: where no other cloth lies on its vertices. What that
// presses on them comes after the solver's answer.
fn is_left(contact : Contact) -> bool {
  if (contact.held != 1u) { return contact.held == kSolved; }
  for (var role = 0u; role < role_count(contact.ids); role++) {
    if (is_collider(contact.ids[role])) { continue; }
    let vertex = contact.ids[role] & kIdBits;
    if ((atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kBesideCloth) != 0u) { return false; }
  }
  return true;
}

// Where another cloth lies on a vertex, the pairs of both bear it: the force that the solver holds it with does not
// stay.
fn forget_hold(vertex : u32) {
  let word = kHoldWords * vertex;
  let was_held = atomicLoad(&presses[word + kHoldNormal]) != 0;
  for (var k = 0u; k < kHoldNormal; k++) { atomicStore(&presses[word + k], 0); }
  // A branch: of a select between the bits of 0 and of -1.0, lavapipe makes a negated number, and so -0, which another
  // pair would take for a force.
  if (was_held) { atomicStore(&presses[word + kHoldNormal], bitcast<i32>(kUnderCloth)); }
}

// Equation (4a) of heavy cloth: how much further an impulse goes that comes to `wanted` in this iteration.
fn ahead_of(number : u32, first : vec3f, wanted : vec3f) -> vec3f {
  if (kLast != 0u) { return vec3f(0.0); }
  let before = step.time.dt * select(begun[number].xyz, first, kFirst != 0u);
  begun[number] = vec4f(wanted / step.time.dt, 0.0);
  return kHeavyAhead * (wanted - before);
}

// The pair's place on cloth, from the body's centre where its way ends.
fn arm_of(contact : Contact, w : vec4f) -> vec3f {
  var place = vec3f(0.0);
  for (var role = 0u; role < 4u; role++) {
    if (!is_collider(contact.ids[role])) { place += abs(w[role]) * previous[contact.ids[role] & kIdBits].xyz; }
  }
  return place - rigid_vector(body_words(contact) + kRigidNext);
}

// Of a pair with a rigid body: the impulse that is wanted, the normal part of it, and W along n. `of_cloth`: the part
// of W that cloth has. Along n first, then from what is left across it: docs/rigid.md, equation (5).
struct Wanted { impulse : vec3f, normal : f32, mobility : f32 }
fn wanted_of_body(contact : Contact, arm : vec3f, u : vec3f, had : vec3f, of_cloth : f32) -> Wanted {
  let body = body_words(contact);
  let inertia = inverse_inertia(body);
  let share = f32(atomicLoad(&rigid[body + kRigidShares])) / contact.urgency;
  let n = contact.normal.xyz;
  let s = across(n);
  let t = cross(n, s);
  let along_n = of_cloth * n + share * body_mobility(body, inertia, arm, n);
  let along_s = share * body_mobility(body, inertia, arm, s);
  let along_t = share * body_mobility(body, inertia, arm, t);
  let mobility = dot(n, along_n);
  let before = dot(n, had);
  let normal = max(0.0, before + (contact.force.w - dot(n, u)) / mobility);
  let then = u + (normal - before) * along_n;
  let half = 0.5 * (dot(s, along_s) - dot(t, along_t));
  let beside = dot(s, along_t);
  let most = of_cloth + 0.5 * (dot(s, along_s) + dot(t, along_t)) + sqrt(half * half + beside * beside);
  let sticking = had - before * n - (then - dot(n, then) * n) / most;
  return Wanted(normal * n + no_longer(sticking, contact.surface.w * normal), normal, mobility);
}

// Equations (2) to (4a) and (7); stores the force.
fn answer(number : u32, contact : Contact, w : vec4f, left : bool) -> Answer {
  let ids = contact.ids;
  var u = contact.surface.xyz;
  var mobility = 0.0;
  for (var role = 0u; role < role_count(ids); role++) {
    if (is_collider(ids[role])) { continue; }
    let vertex = ids[role] & kIdBits;
    u += w[role] * (predicted[vertex].xyz + first_change(vertex));
    let shares = f32(atomicLoad(&vertex_contacts[kVertexWords * vertex + kShareWord])) / kShareUnits;
    mobility += abs(w[role]) * shares * previous[vertex].w;
  }
  mobility /= contact.urgency;
  let with_body = has_body(contact) && contact.solid != kUntangles;
  if (mobility <= 0.0 && !with_body) { return Answer(vec3f(0.0), 0.0); }
  let n = contact.normal.xyz;
  let speed = dot(n, u);
  if (contact.solid == kUntangles) {
    let wanted = -contact.normal.w * contact.thickness * min(kUntanglePart / step.time.dt, kUntangleRate);
    return Answer(max(0.0, wanted - speed) / mobility * n, mobility);
  }
  if (contact.held == kSolved) { return Answer(vec3f(0.0), mobility); }
  let had = step.time.dt * contact.force.xyz;
  if (left) {
    contacts[number].force = vec4f(vec3f(0.0), contact.force.w);
    contacts[number].begun = 0.0;
    return Answer(-had, mobility);
  }
  var normal : f32;
  var along : vec3f;
  if (with_body) {
    let arm = arm_of(contact, w);
    let body = body_words(contact);
    u += body_side(ids) * given_velocity(body, inverse_inertia(body), arm);
    let found = wanted_of_body(contact, arm, u, had, mobility);
    normal = found.normal;
    along = found.impulse - normal * n;
    mobility = found.mobility;
  } else {
    normal = max(0.0, dot(n, had) + (contact.force.w - speed) / mobility);
    let sticking = had - dot(n, had) * n - (u - speed * n) / mobility;
    along = no_longer(sticking, contact.surface.w * normal);
  }
  let ahead = select(kAhead, 0.0, kLast != 0u) * (normal - step.time.dt * contact.begun);
  var impulse = (normal + ahead) * n + along;
  if (kHeavy != 0u) {
    let wanted = normal * n + along;
    impulse = wanted + ahead_of(number, contact.force.xyz, wanted);
  }
  contacts[number].force = vec4f(impulse / step.time.dt, contact.force.w);
  contacts[number].begun = normal / step.time.dt;
  return Answer(impulse - had, mobility);
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_impulse(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let idle = statistics[kStatRolledBack] != 0u || (kWherePressed != 0u && !cloth_is_pressed(statistics[kStatPressed]));
  let count = select(statistics[kStatNear], 0u, idle);
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    if (contacts[number].urgency == 0.0) { continue; }
    let contact = contacts[number];
    if (contact.solid == kUntangles && !is_self_pair(contact.ids)) { continue; }  // see contact_respond
    let w = weights_of(contact.ids, contact.place.x, contact.place.y);
    let left = is_left(contact);
    let given = answer(number, contact, w, left);
    if (given.mobility <= 0.0) { continue; }
    let spared = select(0.0, kHeldLack, left) * contact.thickness;
    let lack = clamp(contact.thickness - spared - contact.normal.w, 0.0, contact.thickness);
    let restored = kPushPart * min(1.0, lack / (kSoftLack * contact.thickness));
    let own = is_self_pair(contact.ids) && !is_of_two_systems(contact);
    let longest = select(kOwnPushTime, kBodyPushTime, (contact.other_end & kOfBodies) != 0u);
    let time = select(step.time.dt, min(step.time.dt, longest), own);
    let apart = min(restored * lack, kPushSpeed * time);  // equation (5a), m
    let pushes = kLast != 0u && contact.solid != kUntangles && apart > 0.0;
    if (has_body(contact)) {
      let body = body_words(contact);
      let arm = arm_of(contact, w);
      let side = body_side(contact.ids);
      add_to_body(body, kRigidSums, arm, side * given.impulse);
      if (pushes) { add_to_body(body, kRigidPushes, arm, side * apart / given.mobility * contact.normal.xyz); }
    }
    for (var role = 0u; role < role_count(contact.ids); role++) {
      if (is_collider(contact.ids[role])) { continue; }
      let vertex = contact.ids[role] & kIdBits;
      let forgets = is_of_two_systems(contact) && w[role] != 0.0;
      if (kPresses != 0u && kLast != 0u && forgets) { forget_hold(vertex); }
      let part = previous[vertex].w * w[role];
      add_units(kVertexWords * vertex + kChangeWord, kSpeedUnits, part * given.impulse);
      if (pushes) {
        add_units(kVertexWords * vertex + kPushWord, kPushUnits,
                  part * apart / given.mobility * contact.normal.xyz);
      }
    }
  }
}
