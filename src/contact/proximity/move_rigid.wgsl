// Rigid bodies at the start of a substep: gravity, the impulses of what they touch, and where that takes them; writes
// their places to `places` as if the scene moved them. One workgroup, an invocation a collider, one after the other
// where bodies act on each other. Source: docs/rigid.md.
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/parting.wgsl"
#include "contact/proximity/take_rigid_sums.wgsl"
#include "contact/proximity/rigid_turn.wgsl"
#include "contact/proximity/rigid_shapes.wgsl"
//                                                                                elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read_write> rigid      : array<u32>;        // kRigidWords * colliders
@group(0) @binding(2) var<storage, read>       hulls      : array<vec4f>;      // corners; faces; edges, m
@group(0) @binding(3) var<storage, read_write> places     : array<vec4f>;      // kPlaceVectors * those * (substeps + 1)
@group(0) @binding(4) var<storage, read_write> touches    : array<vec4f>;      // kTouchVectors * kMostTouches * those
@group(0) @binding(5) var<storage, read_write> statistics : array<atomic<u32>>;
const kThreads = 64u;
const kMostTouches = 16u;   // of a body
const kTouchVectors = 4u;   // point, gap; normal, least speed; velocity of the other, friction; impulse, the other
const kTouchRounds = 12u;
const kTouchPart = 1e-3;    // of the extent: no farther is touched
const kOutPart = 0.2;
const kOutSpeed = 0.5;      // m/s
const kNoFriction = 0.3;    // of two colliders that give none
const kLeastTravel = 1e-9;  // m: bodies that lie still may be struck

var<workgroup> ways : array<f32, kThreads>;
var<workgroup> part_of_way : f32;

fn is_body(c : u32) -> bool { return number_at(kRigidWords * c + kRigidInverseMass) > 0.0; }
fn collider_count() -> u32 { return arrayLength(&rigid) / kRigidWords; }
fn touch_word(body : u32, k : u32) -> u32 { return kTouchVectors * (kMostTouches * body + k); }

fn spin_at(body : u32) -> vec3f {
  let word = kRigidWords * body;
  return spin_of(vector_at(word + kRigidInertia), quaternion_at(word + kRigidTurn), vector_at(word + kRigidMomentum));
}
fn velocity_at(body : u32, point : vec3f) -> vec3f {
  let word = kRigidWords * body;
  return vector_at(word + kRigidVelocity) + cross(spin_at(body), point - vector_at(word + kRigidPlace));
}
// K v at a point; of what is no body 0.
fn mobility_at(body : u32, point : vec3f, v : vec3f) -> vec3f {
  if (!is_body(body)) { return vec3f(0.0); }
  let word = kRigidWords * body;
  let arm = point - vector_at(word + kRigidPlace);
  let turned = spin_of(vector_at(word + kRigidInertia), quaternion_at(word + kRigidTurn), cross(arm, v));
  return number_at(word + kRigidInverseMass) * v + cross(turned, arm);
}
fn give(body : u32, point : vec3f, impulse : vec3f) {
  if (!is_body(body)) { return; }
  let word = kRigidWords * body;
  let arm = point - vector_at(word + kRigidPlace);
  set_vector(word + kRigidVelocity,
             vector_at(word + kRigidVelocity) + number_at(word + kRigidInverseMass) * impulse);
  set_vector(word + kRigidMomentum, vector_at(word + kRigidMomentum) + cross(arm, impulse));
}

// The velocity of what the scene moves, at a point: from the rows of its places.
fn scripted_velocity(c : u32, point : vec3f) -> vec3f {
  let now = kPlaceVectors * (step.contact.first_place + c);
  let then = now + kPlaceVectors * collider_count();
  let d = point - vec3f(places[now].w, places[now + 1u].w, places[now + 2u].w);
  let own = d.x * places[now].xyz + d.y * places[now + 1u].xyz + d.z * places[now + 2u].xyz;
  let p = vec4f(own, 1.0);
  return (vec3f(dot(places[then], p), dot(places[then + 1u], p), dot(places[then + 2u], p)) - point) / step.time.dt;
}

fn velocity_of(c : u32, point : vec3f) -> vec3f {
  if (is_body(c)) { return velocity_at(c, point); }
  return scripted_velocity(c, point);
}

fn friction_between(a : f32, b : f32) -> f32 {
  if (a >= 0.0 && b >= 0.0) { return sqrt(a * b); }
  return select(select(kNoFriction, b, b >= 0.0), a, a >= 0.0);
}

// How much nearer to an obstacle a body may come: where cloth bears it away from that, it lies between them, with its
// thickness to both, or as near as its pairs let the body come.
fn gap_with_cloth(body : u32, other : u32, normal : vec3f, apart : f32) -> f32 {
  let word = kRigidWords * body;
  if (is_body(other) || !lifts(vector_at(word + kRigidLift), normal)) { return apart; }
  return max(apart - 2.0 * step.contact.thickness, -number_at(word + kRigidLack));
}

// Keeps a touch if it is near, in place of the farthest where there are too many.
fn consider(body : u32, other : u32, point : vec3f, normal : vec3f, apart : f32) {
  let word = kRigidWords * body;
  let gap = gap_with_cloth(body, other, normal, apart);
  let of_other = velocity_of(other, point);
  let dt = step.time.dt;
  let speed = dot(normal, velocity_at(body, point) - of_other);
  if (!(gap + min(0.0, 2.0 * dt * speed) < kTouchPart * number_at(word + kRigidExtent))) { return; }
  var least = -max(0.0, gap) / dt;
  let load = step.air.acceleration.xyz;
  let e = step.contact.restitution;
  if (e > 0.0 && -speed > speed_of_load() && gap + dt * speed < 0.0) {
    let toward = select(-dt * dot(normal, load), 0.0, is_body(other));
    least = max(least, e * (-speed - toward) - toward);
  }
  var slot = rigid[word + kRigidTouches];
  if (slot < kMostTouches) {
    rigid[word + kRigidTouches] = slot + 1u;
  } else {
    slot = 0u;
    for (var k = 1u; k < kMostTouches; k++) {
      if (touches[touch_word(body, k)].w > touches[touch_word(body, slot)].w) { slot = k; }
    }
    if (!(gap < touches[touch_word(body, slot)].w)) { return; }
  }
  let at = touch_word(body, slot);
  touches[at] = vec4f(point, gap);
  touches[at + 1u] = vec4f(normal, least);
  touches[at + 2u] = vec4f(of_other, friction_between(number_at(word + kRigidFriction),
                                                      number_at(kRigidWords * other + kRigidFriction)));
  touches[at + 3u] = vec4f(0.0, 0.0, 0.0, f32(other));
}

const kDeepest = 0.05;    // of an extent, that bodies may be in each other where an edge or a rim is asked
fn extent_of(c : u32) -> f32 { return number_at(kRigidWords * c + kRigidExtent); }

// The feet of `a` against the surface of `b`, of which `toward` is the face toward a; `from_b`: the body is b.
fn add_feet(a : u32, b : u32, from_b : bool, toward : Toward) {
  let radius = number_at(kRigidWords * a + kRigidRadius);
  let by_face = radius == 0.0 && has_faces(b);
  let shallow = toward.apart >= -kDeepest * min(extent_of(a), extent_of(b));
  for (var k = 0u; k < foot_count(a); k++) {
    let place = place_in_world(a, foot_of(a, k));
    let own = place_in_own(b, place);
    var depth = depth_of(b, own);
    if (by_face) {
      let out = beside(b, toward.face, own);
      if (out <= 0.0 || (shallow && out <= kTouchPart * extent_of(b))) {
        depth = vec4f(toward.face.xyz, dot(toward.face.xyz, own) - toward.face.w);
      }
    }
    let normal = direction_in_world(b, depth.xyz);
    let gap = depth.w - radius;
    if (from_b) {
      consider(b, a, place - radius * normal, -normal, gap);
    } else {
      consider(a, b, place - radius * normal, normal, gap);
    }
  }
}

const kWithinRod = 1e-3;  // of its length: an end has touches of its own
// A direction from b to a along which they are farthest apart, of those of faces; how far b reaches along it, and how
// near to that an edge must be that can touch, m.
struct Between { along : vec3f, level : f32, room : f32 }
fn between(a : u32, b : u32, of_a : Toward, of_b : Toward) -> Between {
  let v = velocity_at(a, middle_of(a)) - velocity_of(b, middle_of(a));
  var turning = length(spin_at(a)) * extent_of(a);
  if (is_body(b)) { turning += length(spin_at(b)) * extent_of(b); }
  let room = kDeepest * min(extent_of(a), extent_of(b)) + 2.0 * step.time.dt * (length(v) + turning) +
             number_at(kRigidWords * a + kRigidRadius) + number_at(kRigidWords * b + kRigidRadius);
  var best = Between(vec3f(0.0), 0.0, room);
  if (has_faces(b)) {
    let along = direction_in_world(b, of_b.face.xyz);
    best = Between(along, dot(along, middle_of(b)) + of_b.face.w, room - min(of_b.apart, 0.0));
  }
  if (of_a.apart > of_b.apart) {
    let along = -direction_in_world(a, of_a.face.xyz);
    best = Between(along, dot(along, middle_of(a)) - of_a.face.w - of_a.apart, room - min(of_a.apart, 0.0));
  }
  return best;
}
fn add_rods(a : u32, b : u32, of_a : Toward, of_b : Toward) {
  let middle_a = middle_of(a);
  let middle_b = middle_of(b);
  let radius_a = number_at(kRigidWords * a + kRigidRadius);
  let radius_b = number_at(kRigidWords * b + kRigidRadius);
  let deepest = kDeepest * min(extent_of(a), extent_of(b));
  let slab = between(a, b, of_a, of_b);
  for (var i = 0u; i < rod_count(a); i++) {
    let first = rod_of(a, i);
    let p = place_in_world(a, first.start);
    let u = direction_in_world(a, first.along);
    if (dot(slab.along, p) + min(0.0, dot(slab.along, u)) > slab.level + slab.room) { continue; }
    for (var k = 0u; k < rod_count(b); k++) {
      let second = rod_of(b, k);
      let q = place_in_world(b, second.start);
      let v = direction_in_world(b, second.along);
      if (dot(slab.along, q) + max(0.0, dot(slab.along, v)) < slab.level - slab.room) { continue; }
      let square = cross(u, v);
      let size = dot(square, square);
      if (!(size > 1e-6 * dot(u, u) * dot(v, v))) { continue; }
      let r = q - p;
      let s = dot(cross(r, v), square) / size;
      let t = dot(cross(r, u), square) / size;
      if (min(min(s, t), min(1.0 - s, 1.0 - t)) < kWithinRod) { continue; }
      let on_a = p + s * u;
      let on_b = q + t * v;
      var normal = square / sqrt(size);
      if (dot(normal, (on_a - middle_b) + (middle_a - on_b)) < 0.0) { normal = -normal; }
      let gap = dot(normal, on_a - on_b) - radius_a - radius_b;
      if (gap < -deepest || !is_farthest(a, -normal, on_a, kDeepest * extent_of(a)) ||
          !is_farthest(b, normal, on_b, kDeepest * extent_of(b))) {
        continue;
      }
      consider(a, b, on_b + radius_b * normal, normal, gap);
    }
  }
}

fn find_touches(body : u32) {
  let kind = rigid[kRigidWords * body + kRigidKind];
  rigid[kRigidWords * body + kRigidTouches] = 0u;
  for (var other = 0u; other < collider_count(); other++) {
    let of_other = rigid[kRigidWords * other + kRigidKind];
    if (other == body || of_other == kMesh || (is_body(other) && other < body)) { continue; }
    let others_face = face_toward(other, body);
    add_feet(body, other, false, others_face);
    // A ball's one point has been tried.
    if (kind == kBall || of_other == kPlane) { continue; }
    let own_face = face_toward(body, other);
    add_feet(other, body, true, own_face);
    add_rods(body, other, own_face, others_face);
  }
}

// One after the other: docs/rigid.md, equation (4).
fn answer(body : u32, at : u32) {
  let point = touches[at].xyz;
  let n = touches[at + 1u].xyz;
  let had = touches[at + 3u];
  let other = u32(had.w);
  var u = velocity_at(body, point) - touches[at + 2u].xyz;
  if (is_body(other)) { u = velocity_at(body, point) - velocity_at(other, point); }
  let along_n = mobility_at(body, point, n) + mobility_at(other, point, n);
  let before = dot(n, had.xyz);
  let normal = max(0.0, before + (touches[at + 1u].w - dot(n, u)) / dot(n, along_n));
  let change = normal - before;
  u += change * along_n;
  let s = square_to_normal(n);
  let t = cross(n, s);
  let along_s = mobility_at(body, point, s) + mobility_at(other, point, s);
  let along_t = mobility_at(body, point, t) + mobility_at(other, point, t);
  let half = 0.5 * (dot(s, along_s) - dot(t, along_t));
  let beside = dot(s, along_t);
  let most = 0.5 * (dot(s, along_s) + dot(t, along_t)) + sqrt(half * half + beside * beside);
  let along = had.xyz - before * n;
  var wanted = along - (u - dot(n, u) * n) / most;
  let size = length(wanted);
  let limit = touches[at + 2u].w * normal;
  if (size > limit) { wanted *= limit / size; }
  let impulse = change * n + wanted - along;
  give(body, point, impulse);
  give(other, point, -impulse);
  touches[at + 3u] = vec4f(normal * n + wanted, had.w);
}

// What has come too deep is moved out, without speed.
fn move_out(body : u32, count : u32) {
  let word = kRigidWords * body;
  let spared = kTouchPart * number_at(word + kRigidExtent);
  var deep = 0u;
  for (var k = 0u; k < count; k++) { deep += select(0u, 1u, -touches[touch_word(body, k)].w > spared); }
  for (var k = 0u; k < count; k++) {
    let at = touch_word(body, k);
    let depth = -touches[at].w - spared;
    if (!(depth > 0.0)) { continue; }
    let out = min(kOutPart * depth / step.time.dt, kOutSpeed) / f32(deep) * touches[at + 1u].xyz;
    let other = kRigidWords * u32(touches[at + 3u].w);
    let a = number_at(word + kRigidInverseMass);
    let b = number_at(other + kRigidInverseMass);
    set_vector(word + kRigidPush, vector_at(word + kRigidPush) + a / (a + b) * out);
    if (b > 0.0) { set_vector(other + kRigidPush, vector_at(other + kRigidPush) - b / (a + b) * out); }
  }
}

// Where a body's way ends, and how far it takes any point of it, m.
fn go(body : u32) -> f32 {
  let word = kRigidWords * body;
  let dt = step.time.dt;
  let place = vector_at(word + kRigidPlace);
  let turn = quaternion_at(word + kRigidTurn);
  let next = place + dt * (vector_at(word + kRigidVelocity) + vector_at(word + kRigidPush));
  let freely = turned_freely(vector_at(word + kRigidInertia), turn, vector_at(word + kRigidMomentum), dt);
  let next_turn = turned_by(freely, dt * vector_at(word + kRigidPushTurn));
  set_vector(word + kRigidNext, next);
  set_quaternion(word + kRigidNextTurn, next_turn);
  let apart = next_turn - turn;  // 2 sin θ/4, and a chord is 2 sin θ/2 of the distance
  return length(next - place) + 2.0 * sqrt(dot(apart, apart)) * number_at(word + kRigidExtent);
}

// The part of their ways that leads no body out of what the last search has taken as its reach. Thread 0.
fn part_within_reach(way : f32) -> f32 {
  let left = bitcast<f32>(atomicLoad(&statistics[kStatReach])) - bitcast<f32>(atomicLoad(&statistics[kStatTravel]));
  if (step.contact.detect == kDetectAlways || way <= left) { return 1.0; }
  if (step.contact.detect == kDetectIfDue) {
    atomicStore(&statistics[kStatDetect], 1u);
    return 1.0;
  }
  atomicAdd(&statistics[kStatTruncated], 1u);
  return max(0.0, left) / way;
}

fn store_place(place : u32, c : u32, at : vec3f, turn : vec4f, spin : vec3f) {
  let word = kRigidWords * c;
  let whole = product(turn, conjugate(quaternion_at(word + kRigidAxes)));
  let columns = array(rotated(whole, vec3f(1.0, 0.0, 0.0)), rotated(whole, vec3f(0.0, 1.0, 0.0)),
                      rotated(whole, vec3f(0.0, 0.0, 1.0)));
  let shift = at - rotated(whole, vector_at(word + kRigidCenter));
  for (var axis = 0u; axis < 3u; axis++) {
    let row = vec4f(columns[0][axis], columns[1][axis], columns[2][axis], shift[axis]);
    places[kPlaceVectors * place + axis] = row;
    set_quaternion(word + kRigidRows + 4u * axis, row);  // of the end at last
  }
  places[kPlaceVectors * place + 3u] = vec4f(0.0);
  places[kPlaceVectors * place + 4u] = vec4f(spin, 0.0);
}

// With the part of its way that it goes: what cloth meets.
fn set_out(c : u32, part : f32) {
  let word = kRigidWords * c;
  let place = vector_at(word + kRigidPlace);
  let turn = quaternion_at(word + kRigidTurn);
  if (part < 1.0) {
    set_vector(word + kRigidNext, place + part * (vector_at(word + kRigidNext) - place));
    set_quaternion(word + kRigidNextTurn, unit_of(turn + part * (quaternion_at(word + kRigidNextTurn) - turn)));
  }
  let next_turn = quaternion_at(word + kRigidNextTurn);
  let inertia = vector_at(word + kRigidInertia);
  let x = spin_of(inertia, next_turn, vec3f(1.0, 0.0, 0.0));
  let y = spin_of(inertia, next_turn, vec3f(0.0, 1.0, 0.0));
  let z = spin_of(inertia, next_turn, vec3f(0.0, 0.0, 1.0));
  set_vector(word + kRigidInverse, vec3f(x.x, y.y, z.z));
  set_vector(word + kRigidInverse + 3u, vec3f(y.x, z.x, z.y));
  let spin = spin_of(inertia, next_turn, vector_at(word + kRigidMomentum));
  set_vector(word + kRigidFree, vector_at(word + kRigidVelocity));
  set_vector(word + kRigidFreeSpin, spin);
  set_vector(word + kRigidGiven, vec3f(0.0));
  set_vector(word + kRigidGivenTurn, vec3f(0.0));
  store_place(step.contact.first_place + c, c, place, turn, spin);
  store_place(step.contact.first_place + collider_count() + c, c, vector_at(word + kRigidNext), next_turn, spin);
}

@compute @workgroup_size(kThreads)
fn move_rigid(@builtin(local_invocation_index) thread : u32) {
  let count = collider_count();
  for (var c = thread; c < count; c += kThreads) {
    if (!is_body(c)) { continue; }
    let velocity = kRigidWords * c + kRigidVelocity;
    set_vector(velocity, vector_at(velocity) + step.time.dt * step.air.acceleration.xyz);
  }
  storageBarrier();
  for (var c = thread; c < count; c += kThreads) {
    if (is_body(c)) { find_touches(c); }
  }
  storageBarrier();
  if (thread == 0u) {
    for (var round = 0u; round < kTouchRounds; round++) {
      for (var c = 0u; c < count; c++) {
        if (!is_body(c)) { continue; }
        let touched = rigid[kRigidWords * c + kRigidTouches];
        for (var k = 0u; k < touched; k++) { answer(c, touch_word(c, k)); }
      }
    }
    for (var c = 0u; c < count; c++) {
      if (is_body(c)) { move_out(c, rigid[kRigidWords * c + kRigidTouches]); }
    }
  }
  storageBarrier();
  var way = kLeastTravel;
  for (var c = thread; c < count; c += kThreads) {
    if (is_body(c)) { way = max(way, go(c)); }
  }
  ways[thread] = way;
  workgroupBarrier();
  if (thread == 0u) {
    for (var k = 1u; k < kThreads; k++) { way = max(way, ways[k]); }
    part_of_way = part_within_reach(way);
    atomicStore(&statistics[kStatBodyTravel], bitcast<u32>(max(kLeastTravel, part_of_way * way)));
  }
  let part = workgroupUniformLoad(&part_of_way);
  for (var c = thread; c < count; c += kThreads) {
    if (is_body(c)) { set_out(c, part); }
  }
}
