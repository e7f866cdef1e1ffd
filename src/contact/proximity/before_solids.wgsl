// Puts the end of a vertex's way out of the planes of its pairs with what contact cannot move: obstacles, and cloth
// that the scene moves or pins. So cloth slides along them; only what would leave its reach so, or what several planes
// do not let out, ends its way sooner. A rigid body gets what its planes take. The including kernel binds step,
// contacts and rigid, and includes reach.wgsl. Source: docs/contact.md, equation (6).
#include "contact/proximity/solid_planes.wgsl"
#include "contact/proximity/rigid_sums.wgsl"
const kPlaneRounds = 4u;
const kBeyondPlane = 1e-5;  // of the thickness: no way is shortened for less
const kStoppedPart = 0.5;   // of a way: what planes take less of is not stopped, but goes on along them
const kNoBody = 0xffffffffu;

// The end of a vertex's way, and whether anything but what its pairs gave has changed it.
struct Way {
  position : vec3f,   // m
  velocity : vec3f,   // m/s
  lost : vec3f,       // m: what it was to go farther; nothing where it goes on along planes
  changed : bool,
}

// How a solid side that has come past a vertex takes it along.
struct Carry {
  normal : vec3f,  // away from the side
  depth : f32,     // m; 0: it does not
  speed : f32,     // of the side along the normal, m/s
  body : u32,      // of the pair, or kNoBody
}
const kNoCarry = Carry(vec3f(0.0), 0.0, 0.0, kNoBody);

// The deeper of two; of equally deep ones, so that the order of records does not matter, by direction, speed and body.
fn comes_first(a : Carry, b : Carry) -> bool {
  if (a.depth != b.depth) { return a.depth > b.depth; }
  if (a.normal.x != b.normal.x) { return a.normal.x > b.normal.x; }
  if (a.normal.y != b.normal.y) { return a.normal.y > b.normal.y; }
  if (a.normal.z != b.normal.z) { return a.normal.z > b.normal.z; }
  if (a.speed != b.speed) { return a.speed > b.speed; }
  return a.body < b.body;
}

// Where a pair's rigid body is in `rigid`, or kNoBody.
fn body_of(contact : Contact) -> u32 {
  if (!has_body(contact)) { return kNoBody; }
  return body_words(contact);
}

fn deepest_carry(first : u32, far : bool, of_cloth : bool, x : vec3f) -> Carry {
  var deepest = kNoCarry;
  for (var link = first; link != 0u; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    if (!has_plane(contact) || !(far || contact.near != 0u)) { continue; }
    if (!of_cloth && is_self_pair(contact.ids)) { continue; }
    let side = select(-1.0, 1.0, role_of(link) < roles_of_a(contact.ids));
    let depth = beyond(contact, role_of(link), x);
    let carry = Carry(side * contact.normal.xyz, depth, contact.solid_speed, body_of(contact));
    if (comes_first(carry, deepest)) { deepest = carry; }
  }
  return deepest;
}

// A rigid body gets what its plane has taken from a vertex's velocity.
fn give_body(body : u32, start : vec4f, taken : vec3f) {
  if (body == kNoBody) { return; }
  add_to_body(body, kRigidSums, start.xyz - rigid_vector(body + kRigidNext), taken / start.w);
}

// Takes a way's end out of the planes that it is beyond, the deepest first; out of those before cloth too, or not.
fn out_of_planes(way_so_far : Way, begun : vec4f, first : u32, far : bool, of_cloth : bool) -> Way {
  var way = way_so_far;
  for (var round = 0u; round < kPlaneRounds; round++) {
    let carry = deepest_carry(first, far, of_cloth, way.position);
    if (carry.depth <= 0.0) { break; }
    way.position += carry.depth * carry.normal;
    let more = clamp(carry.speed - dot(carry.normal, way.velocity), 0.0, carry.depth / step.time.dt) * carry.normal;
    way.velocity += more;
    if (kRigid) { give_body(carry.body, begun, -more); }
    way.changed = true;
  }
  return way;
}

// Only where a plane is near enough to be met, or the way so long that any may be.
fn before_solids(way_so_far : Way, begun : vec4f, first : u32, tight : f32, reach : Reach) -> Way {
  let start = begun.xyz;
  let length_of_way = 1.001 * length(way_so_far.position - start);
  let far = length_of_way > free_way();
  if (first == 0u || !(far || length_of_way > free_way() - tight)) { return way_so_far; }
  var way = out_of_planes(way_so_far, begun, first, far, false);
  let moved = way.position - way_so_far.position;
  if (length(moved) > kStoppedPart * length_of_way) { way.lost -= moved; }
  let slid = way.position;
  let within = place_within(reach, slid);
  way.lost += slid - within;
  way.position = within;
  var part = 1.0;
  var stopped_by = kNoBody;
  var driven = false;  // what comes has passed it
  for (var link = first; link != 0u; link = next_of(link)) {
    let contact = contacts[record_of(link)];
    if (!has_plane(contact) || !(far || contact.near != 0u)) { continue; }
    let now = beyond(contact, role_of(link), start);
    let then = beyond(contact, role_of(link), way.position);
    driven = driven || (now >= 0.0 && then > 0.0);
    if (!(now < 0.0 && then > kBeyondPlane * contact.thickness)) { continue; }
    let until = now / (now - then);
    let body = body_of(contact);  // of equally near planes the lowest, since records have no order
    if (until < part || (until == part && body < stopped_by)) { stopped_by = body; }
    part = min(part, until);
  }
  if (part < 1.0) {
    if (kRigid) { give_body(stopped_by, begun, (1.0 - part) * way.velocity); }
    way.lost += (1.0 - part) * (way.position - start);
    way.position = start + part * (way.position - start);
    way.velocity *= part;
    way.changed = true;
  }
  if (part == 1.0 && !driven && all(within == slid)) { return way; }
  return out_of_planes(way, begun, first, far, true);
}
