// Holds a vertex back from whatever it would pass through: its reach, then the planes of its pairs. The including
// kernel binds step, contacts, entries and statistics, and sets kDetectInterval.
// Source: docs/contact.md, Reach and equation (6).
#include "state/contact.wgsl"
#include "contact/proximity/planes.wgsl"
const kPushes = 4u;

// Of two pushes, direction and depth: the deeper; of equally deep ones, so that the order of entries does not matter,
// by direction.
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

// How much of a way takes a vertex past no plane that it has been short of by `now` and would be by `then`; one that it
// is past already it passes no further where that `binds`.
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

// The end of a vertex's way, and whether anything but its pairs' impulses has changed it.
struct Way {
  position : vec3f,   // m
  velocity : vec3f,   // m/s
  held_back : bool,
}

// Beyond its reach a vertex could meet an unlisted feature, so it stays in the ball around its place at the search.
fn within_reach(way_so_far : Way, start : vec3f, found : vec4f) -> Way {
  var result = way_so_far;
  let reach = found.w;
  let way = result.position - start;
  let away = start - found.xyz;
  let square = dot(way, way);
  let beyond_reach = away + way;
  if (dot(beyond_reach, beyond_reach) > reach * reach) {
    let along = dot(way, away);
    let room = max(reach * reach - dot(away, away), 0.0);
    result.position = start + clamp((sqrt(along * along + square * room) - along) / square, 0.0, 1.0) * way;
    // It goes on no faster than reaches let it, or its neighbours would pull it ever faster.
    result.velocity *= min(1.0, reach / (kDetectInterval * step.time.dt * length(result.velocity)));
    atomicAdd(&statistics[kStatTruncated], 1u);
  }
  return result;
}

// Equation (6), where a plane is near enough to be met: the way ends before the planes between it and what it would
// pass through, and a solid side that comes nearer takes the vertex with it.
fn before_planes(way_so_far : Way, start : vec3f, begin : u32, end : u32, tight : f32) -> Way {
  var x = way_so_far.position;
  let length_of_way = 1.001 * length(x - start);
  let far = length_of_way > free_way();
  // No solid side comes nearer: a vertex within a margin may stay there.
  let still = step.contact.collider_travel == 0.0;
  if (begin >= end || !(far || length_of_way > free_way() - tight)) { return way_so_far; }
  var part = 1.0;
  var deepest = vec4f(0.0);
  for (var k = begin; k < end; k++) {
    if (!far && (entries[k] & kEntryNear) == 0u) { continue; }
    let contact = contacts[entries[k] / kEntryPair];
    if (contact.normal.w <= 0.0) { continue; }  // inside a ball or below a plane: the contact spring moves it out
    let then = beyond(contact, entries[k] & 3u, x);
    if (then <= 0.0) { continue; }
    part = min(part, part_before(beyond(contact, entries[k] & 3u, start), then, contact.solid == 0u || still));
    if (contact.solid != 0u) { deepest = deeper(deepest, contact, entries[k] & 3u, then); }
  }
  if (part < 1.0) {
    x = start + part * (x - start);
    deepest = deepest_push(begin, end, far, x);
  }
  let pushed = deepest.w > 0.0;
  let unpushed = x;
  for (var round = 1u; round <= kPushes && deepest.w > 0.0; round++) {  // the deepest first
    x += deepest.w * deepest.xyz;
    deepest = vec4f(0.0);
    if (round < kPushes) { deepest = deepest_push(begin, end, far, x); }
  }
  if (pushed && still) { x = unpushed + part_before_cloth(begin, end, far, unpushed, x) * (x - unpushed); }
  return Way(x, way_so_far.velocity, part < 1.0 || pushed);
}
