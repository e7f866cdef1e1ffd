// Adds the velocity change of each acting pair to its vertices. Grid-stride loop over the pairs.
// Source: docs/contact.md, equations (2) to (5) and (7).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // 2 * vertex_count  m/s, then m
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(5) var<storage, read>       statistics      : array<u32>;
const kContactSpring = 0.25;   // β: of the missing gap, the part that a substep restores
const kContactWall = 0.25;     // of the thickness: no pair comes nearer

// The sum of the urgencies at a vertex, of which each pair gets its part of the mass.
fn acting(vertex : u32) -> f32 {
  return f32(atomicLoad(&vertex_contacts[kVertexWords * vertex + kUrgencyWord]));
}

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
  let thickness = select(step.contact.thickness, step.contact.self_thickness, is_self_pair(ids));
  let speed = dot(n, u);
  var change = min(kContactWall * thickness - gap, 0.0) / step.time.dt - speed;
  if (contact.solid == kUntangles) {
    change = -gap * thickness * min(kUntanglePart / step.time.dt, kUntangleRate) - speed;
  } else if (gap < kContactTouching * thickness) {
    let pull_apart = kContactSpring * clamp(thickness - gap, 0.0, thickness) / step.time.dt;
    change = max(change, pull_apart - step.contact.damping * speed);
  } else {  // it comes to the thickness and no further
    change = max(change, step.contact.damping * ((thickness - gap) / step.time.dt - speed));
  }
  if (change <= 0.0) { return vec3f(0.0); }
  let sliding = u - speed * n;
  let slip = length(sliding);
  var friction = vec3f(0.0);
  if (slip > 0.0 && contact.solid != kUntangles) {
    friction = (min(contact.surface.w * change, slip) / slip) * sliding;
  }
  return (change * n - friction) / mobility;
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_impulse(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let count = select(statistics[kStatPairs], 0u, statistics[kStatRolledBack] != 0u);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    if (contacts[pair].urgency == 0.0) { continue; }
    let contact = contacts[pair];
    if (contact.solid == kUntangles && !is_self_pair(contact.ids)) { continue; }  // see contact_respond
    let on_a = impulse(contact);
    let weights = weights_of(contact.ids, contact.place.x, contact.place.y);
    for (var role = 0u; role < role_count(contact.ids); role++) {
      if (is_collider(contact.ids[role])) { continue; }
      let vertex = contact.ids[role] & kIdBits;
      let change = kSpeedUnits * (previous[vertex].w * weights[role]) * on_a;
      let units = vec3i(round(clamp(change, vec3f(-kMostUnits), vec3f(kMostUnits))));
      for (var axis = 0u; axis < 3u; axis++) {
        if (units[axis] != 0) {
          atomicAdd(&vertex_contacts[kVertexWords * vertex + kChangeWord + axis], bitcast<u32>(units[axis]));
        }
      }
    }
  }
}
