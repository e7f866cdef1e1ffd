// Gives a vertex what its pairs change of its velocity, then holds it back from whatever it would pass through. One invocation per
// vertex. Source: docs/contact.md, equations (6) and (7d).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/planes.wgsl"
//                                                                                     elements              unit
@group(0) @binding(0) var<uniform>             step            : StepParams;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>;        // vertex_count          m (w: inverse mass, 1/kg)
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>;        // 2 * vertex_count      m/s, then m: state/contact.wgsl
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read>       entries         : array<u32>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<vec4u>;        // 2 * vertex_count: state/contact.wgsl
@group(0) @binding(6) var<storage, read_write> position        : array<vec4f>;        // vertex_count          m
@group(0) @binding(7) var<storage, read_write> velocity        : array<vec4f>;        // vertex_count          m/s
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;
const kPushes = 4u;

// What pairs with bodies that a vertex is inside of ask of it, in sums of integers.
struct OutOfBody {
  way : vec3i,      // 2^-16
  surface : vec3i,  // the bodies' velocity, 2^-16 m/s
  parts : u32,      // 2^-16
}
const kPartUnits = 65536.0;

fn bodies_around(begin : u32, end : u32) -> OutOfBody {
  var body = OutOfBody(vec3i(0), vec3i(0), 0u);
  for (var k = begin; k < end; k++) {
    if ((entries[k] & kEntryNear) == 0u) { continue; }
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.solid != kUntangles || contact.urgency == 0.0 || is_self_pair(contact.ids)) { continue; }
    let weight = weights_of(contact.ids, contact.place.x, contact.place.y)[entries[k] & 3u];
    let part = kPartUnits * weight * -contact.normal.w;
    body.way += vec3i(round(part * contact.normal.xyz));
    body.surface -= vec3i(round(clamp(part * contact.surface.xyz, vec3f(-kMostUnits), vec3f(kMostUnits))));
    body.parts += u32(round(abs(part)));
  }
  return body;
}

// Equation (7d): a body gives no way, and its facets do not agree on where outside is. The vertex goes where most of them say.
fn out_of_body(body : OutOfBody, v : vec3f) -> vec3f {
  if (body.parts == 0u) { return vec3f(0.0); }
  let way = vec3f(body.way) / f32(body.parts);
  let agreement = length(way);
  if (agreement <= 0.0) { return vec3f(0.0); }
  let n = way / agreement;
  let wanted = step.thickness * min(kUntanglePart / step.dt, kUntangleRate);
  return max(0.0, wanted - dot(n, v - vec3f(body.surface) / f32(body.parts))) * n;
}

// Of two pushes, direction and depth: the deeper; of equally deep ones, so that the order of entries does not matter, by direction.
fn comes_first(a : vec4f, b : vec4f) -> bool {
  if (a.w != b.w) { return a.w > b.w; }
  if (a.x != b.x) { return a.x > b.x; }
  if (a.y != b.y) { return a.y > b.y; }
  return a.z > b.z;
}

fn deeper(other : vec4f, contact : Contact, role : u32, depth : f32) -> vec4f {
  let side = select(-1.0, 1.0, role < roles_of_a(contact.ids));
  let push = vec4f(side * contact.normal.xyz, depth);
  if (comes_first(push, other)) { return push; }
  return other;
}
fn deepest_push(begin : u32, end : u32, far : bool, x : vec3f) -> vec4f {
  var deepest = vec4f(0.0);
  for (var k = begin; k < end; k++) {
    if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.normal.w <= 0.0 || contact.solid == 0u) { continue; }
    deepest = deeper(deepest, contact, entries[k] & 3u, beyond(contact, entries[k] & 3u, x));
  }
  return deepest;
}

// How much of a way takes a vertex past no plane that it has been short of by `now` and would be by `then`; one that it is past already it
// passes no further where that `binds`.
fn part_before(now : f32, then : f32, binds : bool) -> f32 {
  if (then <= 0.0) { return 1.0; }
  if (now < 0.0) { return now / (now - then); }
  return select(1.0, 0.0, binds && then > now);
}

// The part of a push that takes a vertex past no plane between it and other cloth.
fn part_before_cloth(begin : u32, end : u32, far : bool, x : vec3f, pushed : vec3f) -> f32 {
  var part = 1.0;
  for (var k = begin; k < end; k++) {
    if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.normal.w <= 0.0 || contact.solid != 0u) { continue; }
    part = min(part, part_before(beyond(contact, entries[k] & 3u, x), beyond(contact, entries[k] & 3u, pushed), true));
  }
  return part;
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_respond(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.vertex_count) { return; }
  let words = vertex_contacts[2u * vertex];
  let begin = words.x;
  let end = begin + words.y;
  let acted_on = words[kUrgencyWord] != 0u;
  let tight = bitcast<f32>(words[kTightWord]);
  if (acted_on || tight > 0.0) { vertex_contacts[2u * vertex] = vec4u(begin, words.y, 0u, 0u); }  // for the next substep
  if (vertex == 0u) {
    atomicMax(&statistics[kStatCrossings], atomicLoad(&statistics[kStatFound]));
    let travel = bitcast<f32>(atomicLoad(&statistics[kStatTravel])) + step.acceleration.w;
    atomicStore(&statistics[kStatTravel], bitcast<u32>(travel));
    let next = kReachMargin * kDetectInterval * step.acceleration.w;
    if (next > 0.0 && travel + next > bitcast<f32>(atomicLoad(&statistics[kStatReach]))) { atomicStore(&statistics[kStatDetect], 1u); }
    if (atomicLoad(&statistics[kStatFound]) != 0u) { atomicStore(&statistics[kStatDetect], 1u); }  // what crosses comes ring by ring
  }

  let found = predicted[step.vertex_count + vertex];
  let reach = found.w;
  let start = previous[vertex];
  let inverse_mass = start.w;
  let unhindered = position[vertex].xyz;
  var x = unhindered;
  var v = predicted[vertex].xyz;
  if (inverse_mass > 0.0) {
    if (acted_on) {
      let more = vertex_contacts[2u * vertex + 1u];
      vertex_contacts[2u * vertex + 1u] = vec4u(more.x, 0u, 0u, 0u);
      let sum = bitcast<vec3i>(more.yzw);
      let change = vec3f(sum) / kSpeedUnits;
      v += change;
      x += step.dt * change;
    }
    if (tight >= kInBody) {
      let change = out_of_body(bodies_around(begin, end), v);
      v += change;
      x += step.dt * change;
    }
    // Beyond its reach a vertex could meet what is not listed: it goes as far as the ball around where it was found.
    var held = false;
    let way = x - start.xyz;
    let away = start.xyz - found.xyz;
    let square = dot(way, way);
    let beyond_reach = away + way;
    if (dot(beyond_reach, beyond_reach) > reach * reach) {
      let along = dot(way, away);
      let room = max(reach * reach - dot(away, away), 0.0);
      x = start.xyz + clamp((sqrt(along * along + square * room) - along) / square, 0.0, 1.0) * way;
      // It goes on no faster than reaches let it, or its neighbours would pull it ever faster.
      v *= min(1.0, reach / (kDetectInterval * step.dt * length(v)));
      atomicAdd(&statistics[kStatTruncated], 1u);
    }
    // Equation (6), where a plane is near enough to be met.
    let length_of_way = 1.001 * length(x - start.xyz);
    let far = length_of_way > free_way();
    let still = step.acceleration.w == 0.0;  // no solid side comes nearer: what is within a margin may stay there
    if (begin < end && (far || length_of_way > free_way() - tight)) {
      var part = 1.0;
      var deepest = vec4f(0.0);
      for (var k = begin; k < end; k++) {
        if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
        let contact = contacts[entries[k] / kEntryPair];
        if (contact.normal.w <= 0.0) { continue; }  // inside a ball or below a plane: the spring brings it out
        let then = beyond(contact, entries[k] & 3u, x);
        if (then <= 0.0) { continue; }
        part = min(part, part_before(beyond(contact, entries[k] & 3u, start.xyz), then, contact.solid == 0u || still));
        if (contact.solid != 0u) { deepest = deeper(deepest, contact, entries[k] & 3u, then); }
      }
      if (part < 1.0) {
        x = start.xyz + part * (x - start.xyz);
        deepest = deepest_push(begin, end, far, x);
      }
      // A solid side that comes nearer takes the vertex with it, the deepest first.
      let pushed = deepest.w > 0.0;
      let unpushed = x;
      for (var round = 1u; round <= kPushes && deepest.w > 0.0; round++) {
        x += deepest.w * deepest.xyz;
        deepest = vec4f(0.0);
        if (round < kPushes) { deepest = deepest_push(begin, end, far, x); }
      }
      if (pushed && still) { x = unpushed + part_before_cloth(begin, end, far, unpushed, x) * (x - unpushed); }
      held = part < 1.0 || pushed;
    }
    if (held) {  // it has the velocity that it came by, or its neighbours would pull it ever faster
      v = (x - start.xyz) / step.dt;
      atomicAdd(&statistics[kStatTruncated], 1u);
    }
    position[vertex] = vec4f(x, inverse_mass);
  }
  // A blow is no part of the motion that an implicit solver goes on from: Solver::reads_step_before.
  let untouched = all(v == predicted[vertex].xyz) && all(x == unhindered);
  velocity[vertex] = vec4f(v, select(0.0, predicted[vertex].w, untouched));
  let gone = length(x - found.xyz);
  if (gone + kReachMargin * kDetectInterval * length(x - start.xyz) > reach) { atomicStore(&statistics[kStatDetect], 1u); }
}
