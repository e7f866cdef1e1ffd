// Answers the pairs that act at a vertex, then holds it back from whatever it would pass through. One invocation per vertex. Source: docs/contact.md, equations (2) to (7).
#include "shared/index.wgsl"
#include "shared/step.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
//                                                                                     elements              unit
@group(0) @binding(0) var<uniform>             step            : StepParams;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>;        // vertex_count          m (w: inverse mass, 1/kg)
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>;        // 2 * vertex_count      m/s, then m: shared/contact.wgsl
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read>       entries         : array<u32>;
@group(0) @binding(5) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> position        : array<vec4f>;        // vertex_count          m
@group(0) @binding(7) var<storage, read_write> velocity        : array<vec4f>;        // vertex_count          m/s
@group(0) @binding(8) var<storage, read_write> statistics      : array<atomic<u32>>;
const kSpring = 0.25;   // β: of the gap that is missing, what a substep makes good
const kWall = 0.25;     // of the thickness: no pair comes nearer
const kUntanglePart = 0.125;  // of the thickness: how far apart what crosses comes in a substep
const kUntangleRate = 120.0;  // thicknesses a second: likewise
const kMargin = 0.05;   // of the distance: how near to the plane between two features a vertex may come
const kSpeedUnits = 4194304.0;  // 2^22 in a metre a second: sums stay below 512 m/s
const kMostUnits = 1.0e9;
const kPushes = 4u;
const kFloor = 0.1;     // of the thickness: likewise; nearer, f32 does not know the plane well enough along a whole edge

// The sum of the urgencies at a vertex, of which each pair gets its part of the mass.
fn acting(vertex : u32) -> f32 {
  return f32(atomicLoad(&vertex_contacts[kVertexWords * vertex + 2u + step.parity]) / kUrgencyUnit);
}

fn thickness_of(ids : vec4u) -> f32 { return select(step.thickness, step.self_thickness, is_self_pair(ids)); }

// Equations (2) to (4): the impulse on side A, N·s.
fn impulse(contact : Contact) -> vec3f {
  let ids = contact.ids;
  let w = weights_of(ids, contact.place.x, contact.place.y);
  var u = contact.surface.xyz;
  var mobility = 0.0;  // W, 1/kg
  for (var role = 0u; role < role_count(ids); role++) {
    if (is_collider(ids[role])) { continue; }
    let vertex = ids[role] & kIdBits;
    u += w[role] * predicted[vertex].xyz;
    mobility += w[role] * w[role] * acting(vertex) * previous[vertex].w;
  }
  mobility /= contact.urgency;
  if (mobility <= 0.0) { return vec3f(0.0); }
  let n = contact.normal.xyz;
  let gap = contact.normal.w;
  let thickness = thickness_of(ids);
  let speed = dot(n, u);
  var change = min(kWall * thickness - gap, 0.0) / step.dt - speed;
  if (contact.solid == kUntangles) {
    change = -gap * thickness * min(kUntanglePart / step.dt, kUntangleRate) - speed;
  } else if (gap < kTouching * thickness) {
    change = max(change, kSpring * clamp(thickness - gap, 0.0, thickness) / step.dt - step.contact_damping * speed);
  } else {  // it comes to the thickness and no further
    change = max(change, step.contact_damping * ((thickness - gap) / step.dt - speed));
  }
  if (change <= 0.0) { return vec3f(0.0); }
  let sliding = u - speed * n;
  let slip = length(sliding);
  var friction = vec3f(0.0);
  if (slip > 0.0 && contact.solid != kUntangles) { friction = (min(contact.surface.w * change, slip) / slip) * sliding; }
  return (change * n - friction) / mobility;
}

// What pairs with bodies that a vertex is inside of ask of it, in sums of integers.
struct OutOfBody {
  way : vec3i,      // 2^-16
  surface : vec3i,  // the bodies' velocity, 2^-16 m/s
  parts : u32,      // 2^-16
}
const kPartUnits = 65536.0;

// Equation (7d): a body gives no way, and its facets do not agree on where outside is. The vertex goes where most of them say.
fn out_of_body(body : OutOfBody, v : vec3f) -> vec3f {
  let way = vec3f(body.way) / f32(body.parts);
  let agreement = length(way);
  if (agreement <= 0.0) { return vec3f(0.0); }
  let n = way / agreement;
  let wanted = step.thickness * min(kUntanglePart / step.dt, kUntangleRate);
  return max(0.0, wanted - dot(n, v - vec3f(body.surface) / f32(body.parts))) * n;
}

// How far beyond the plane that it must stay behind a place lies, m; negative: it is on its own side.
fn beyond(contact : Contact, role : u32, place : vec3f) -> f32 {
  let on_a = role < roles_of_a(contact.ids);
  let side = select(-1.0, 1.0, on_a);
  let gap = contact.normal.w;
  var plane = contact.place.z - 0.5 * gap + side * max(kMargin * gap, 0.5 * kFloor * step.self_thickness);
  if (contact.solid != 0u) {
    let thickness = thickness_of(contact.ids);
    plane = contact.place.w + side * max(kMargin * min(gap, thickness), kFloor * thickness);
  }
  return side * (plane - dot(contact.normal.xyz, place));
}

// Of two pushes, direction and depth: the deeper; of equally deep ones, so that the order of entries does not matter, by direction.
fn comes_first(a : vec4f, b : vec4f) -> bool {
  if (a.w != b.w) { return a.w > b.w; }
  if (a.x != b.x) { return a.x > b.x; }
  if (a.y != b.y) { return a.y > b.y; }
  return a.z > b.z;
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_respond(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.vertex_count) { return; }
  let words = kVertexWords * vertex;
  let begin = atomicLoad(&vertex_contacts[words]);
  let end = begin + atomicLoad(&vertex_contacts[words + 1u]);
  let count = atomicLoad(&vertex_contacts[words + 2u + step.parity]);
  atomicStore(&vertex_contacts[words + 3u - step.parity], 0u);  // for the next substep
  if (vertex == 0u) {
    atomicMax(&statistics[kStatCrossings], atomicLoad(&statistics[kStatFound]));
    let travel = bitcast<f32>(atomicLoad(&statistics[kStatTravel])) + step.acceleration.w;
    atomicStore(&statistics[kStatTravel], bitcast<u32>(travel));
    let next = kReachMargin * kDetectInterval * step.acceleration.w;
    if (next > 0.0 && travel + next > bitcast<f32>(atomicLoad(&statistics[kStatReach]))) { atomicStore(&statistics[kStatDetect], 1u); }
    if (atomicLoad(&statistics[kStatFound]) != 0u) { atomicStore(&statistics[kStatDetect], 1u); }  // what crosses comes ring by ring
  }

  let reach = bitcast<f32>(atomicLoad(&statistics[kStatReach]));
  let start = previous[vertex];
  let inverse_mass = start.w;
  var x = position[vertex].xyz;
  var v = predicted[vertex].xyz;
  if (inverse_mass > 0.0) {
    if (count >= kUrgencyUnit) {
      var sum = vec3i(0);  // entries have no order, so their sum is of integers
      var body = OutOfBody(vec3i(0), vec3i(0), 0u);
      for (var k = begin; k < end; k++) {
        let entry = entries[k];
        if ((entry & kEntryActs) == 0u) { continue; }
        let contact = contacts[entry / 16u];
        let weight = weights_of(contact.ids, contact.place.x, contact.place.y)[entry & 3u];
        if (contact.solid == kUntangles && !is_self_pair(contact.ids)) {
          let part = kPartUnits * weight * -contact.normal.w;
          body.way += vec3i(round(part * contact.normal.xyz));
          body.surface -= vec3i(round(clamp(part * contact.surface.xyz, vec3f(-kMostUnits), vec3f(kMostUnits))));
          body.parts += u32(round(abs(part)));
          continue;
        }
        let change = (inverse_mass * weight) * impulse(contact);
        sum += vec3i(round(clamp(kSpeedUnits * change, vec3f(-kMostUnits), vec3f(kMostUnits))));
      }
      var change = vec3f(sum) / kSpeedUnits;
      if (body.parts > 0u) { change += out_of_body(body, v + change); }
      v += change;
      x += step.dt * change;
    }
    // Beyond its reach a vertex could meet what is not listed: it goes as far as the ball around where it was found.
    var held = false;
    let way = x - start.xyz;
    let away = start.xyz - predicted[step.vertex_count + vertex].xyz;
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
    // Equation (6). What moves less than this passes nothing that is not near.
    let free = 0.45 * select(step.thickness, min(step.thickness, step.self_thickness), step.self_thickness > 0.0);
    let far = length(x - start.xyz) > free;
    if (begin < end && (far || count > 0u)) {
      var part = 1.0;
      for (var k = begin; k < end; k++) {
        if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
        let contact = contacts[entries[k] / 16u];
        if (contact.normal.w <= 0.0) { continue; }  // inside a ball or below a plane: the spring brings it out
        let now = beyond(contact, entries[k] & 3u, start.xyz);
        let then = beyond(contact, entries[k] & 3u, x);
        if (then <= 0.0) { continue; }
        if (now < 0.0) { part = min(part, now / (now - then)); } else if (contact.solid == 0u && then > now) { part = 0.0; }
      }
      if (part < 1.0) { x = start.xyz + part * (x - start.xyz); }
      var pushed = false;
      for (var round = 0u; round < kPushes; round++) {  // a solid side that comes nearer takes the vertex with it, the deepest first
        var deepest = vec4f(0.0);
        for (var k = begin; k < end; k++) {
          if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
          let contact = contacts[entries[k] / 16u];
          if (contact.normal.w <= 0.0 || contact.solid == 0u) { continue; }
          let side = select(-1.0, 1.0, (entries[k] & 3u) < roles_of_a(contact.ids));
          let push = vec4f(side * contact.normal.xyz, beyond(contact, entries[k] & 3u, x));
          if (comes_first(push, deepest)) { deepest = push; }
        }
        if (deepest.w <= 0.0) { break; }
        x += deepest.w * deepest.xyz;
        pushed = true;
      }
      held = part < 1.0 || pushed;
    }
    if (held) {  // it has the velocity that it came by, or its neighbours would pull it ever faster
      v = (x - start.xyz) / step.dt;
      atomicAdd(&statistics[kStatTruncated], 1u);
    }
    position[vertex] = vec4f(x, inverse_mass);
  }
  velocity[vertex] = vec4f(v, 0.0);
  let gone = length(x - predicted[step.vertex_count + vertex].xyz);
  if (gone + kReachMargin * kDetectInterval * length(x - start.xyz) > reach) { atomicStore(&statistics[kStatDetect], 1u); }
}
