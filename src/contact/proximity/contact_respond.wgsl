// What contact gives a vertex in a substep: the velocity change and the push of its pairs; then its reach and the
// planes of obstacles end its way. Asks for a search where colliders need one, and clears its words. One invocation per
// vertex. Source: docs/contact.md, equations (5) to (6) and (7d).
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/leave_bodies.wgsl"
#include "contact/proximity/reach.wgsl"
#include "contact/proximity/before_solids.wgsl"
#include "contact/proximity/schedule_search.wgsl"
#include "contact/proximity/impulse_moves.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       previous        : array<vec4f>; // vertex_count      m; w: 1/kg
@group(0) @binding(2) var<storage, read>       predicted       : array<vec4f>; // 3 * vertex_count  m/s, then m
@group(0) @binding(3) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(4) var<storage, read_write> vertex_contacts : array<vec4u>; // 4 * vertex_count: state/contact.wgsl
@group(0) @binding(5) var<storage, read_write> position        : array<vec4f>; // vertex_count      m
@group(0) @binding(6) var<storage, read_write> velocity        : array<vec4f>; // vertex_count      m/s
@group(0) @binding(7) var<storage, read_write> statistics      : array<atomic<u32>>;
@group(0) @binding(8) var<storage, read_write> rigid           : array<atomic<u32>>;

override kKeepsLost : bool = false;  // what ways lose is kept for the edges beside them: kLostWord
override kAllIterations : u32 = 1;  // 0: what impulses of pressed cloth need more is not recorded

// Where cloth was pressed, a frame in which impulses had too few iterations is to be repeated.
fn ask_for_iterations() {
  if (cloth_is_pressed(atomicLoad(&statistics[kStatPressed]))) {
    atomicStore(&statistics[kStatPressing], 1u);
    if (kAllIterations == 0u) { atomicStore(&statistics[kStatRolledBack], 1u); }
  }
  atomicStore(&statistics[kStatPressed], 0u);
}

@compute @workgroup_size(kWorkgroupSize)
fn contact_respond(@builtin(global_invocation_id) id : vec3u) {
  let vertex = flat_index(id);
  if (vertex >= step.nodes.count) { return; }
  let at = kVertexWords / 4u * vertex;
  let words = vertex_contacts[at];
  let sums = array(vertex_contacts[at + 1u], vertex_contacts[at + 2u], vertex_contacts[at + 3u]);
  let records = words[kLinkWord];
  let acted_on = words[kShareWord] != 0u;
  let tight = bitcast<f32>(words[kTightWord]);
  // Cleared for the next substep.
  if (acted_on || tight > 0.0 || sums[2].z != 0u || words[kPartWord] != 0u) {
    vertex_contacts[at] = vec4u(records, 0u, 0u, 0u);
    vertex_contacts[at + 1u] = vec4u(sums[0].x, 0u, 0u, 0u);
    vertex_contacts[at + 2u] = vec4u(0u);
    vertex_contacts[at + 3u] = vec4u(0u);
  }
  if (vertex == 0u) {
    schedule_for_colliders();
    ask_for_iterations();
    atomicStore(&statistics[kStatMeeting], 0u);
    atomicStore(&statistics[kStatSlowPart], 0u);
    atomicStore(&statistics[kStatDelayBefore], atomicLoad(&statistics[kStatDelayUs]));
  }

  let found = predicted[step.nodes.count + vertex];
  let reach = Reach(found.xyz, found.w, predicted[2u * step.nodes.count + vertex].xyz);
  let start = previous[vertex];
  let inverse_mass = start.w;
  let unhindered = position[vertex].xyz;
  var way = Way(unhindered, predicted[vertex].xyz, vec3f(0.0), false);
  if (inverse_mass > 0.0) {
    if (acted_on) {
      let change = vec3f(bitcast<vec3i>(sums[0].yzw) + bitcast<vec3i>(sums[1].xyz)) / kSpeedUnits;
      let push = vec3f(bitcast<vec3i>(vec3u(sums[1].w, sums[2].xy))) / kPushUnits;
      way.velocity += change;
      way.position += select(0.0, step.time.dt, impulses_move(sums[2].z)) * change + push;
    }
    if (tight >= kInBody) {
      let change = out_of_body(bodies_around(records), way.velocity);
      way.velocity += change;
      way.position += step.time.dt * change;
    }
    let within = place_within(reach, way.position);  // beyond, it could meet an unlisted feature
    let back = length(within - way.position);
    if (back > 0.0) {
      let n = (within - way.position) / back;
      let slower = min(back / step.time.dt, max(0.0, -dot(n, way.velocity)));  // a push is in no velocity
      way = Way(within, way.velocity + slower * n, -back * n, true);
    }
    if ((sums[2].z & kBesideSolid) != 0u) { way = before_solids(way, start, records, tight, reach); }
    if (way.changed) { atomicAdd(&statistics[kStatTruncated], 1u); }
    let goes_far = length(way.position - start.xyz) > free_way();
    if (goes_far) { atomicStore(&statistics[kStatFarWays], 1u); }
    let held = select(0u, kCounted, way.changed) | select(0u, kFarWay, goes_far);
    if (held != 0u) { vertex_contacts[at + 3u] = vec4u(0u, 0u, held, 0u); }
    if (kKeepsLost && way.changed) { vertex_contacts[at + 2u] = vec4u(bitcast<vec3u>(way.lost), 0u); }
    position[vertex] = vec4f(way.position, inverse_mass);
  }
  // An impulse breaks the motion that an implicit solver extrapolates (Method::history), so its history is invalid.
  let untouched = all(way.velocity == predicted[vertex].xyz) && all(way.position == unhindered);
  velocity[vertex] = vec4f(way.velocity, select(0.0, predicted[vertex].w, untouched));
}
