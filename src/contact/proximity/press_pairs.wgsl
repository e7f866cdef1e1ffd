// Finds the pairs of features of one cloth that come near in the substep about to be solved, by the velocities at its
// start: equation (1) of docs/contact.md. Their vertices take it in one formula, backward Euler, so that forces keep
// momentum. Grid-stride loop over the records. Source: docs/solvers/multigrid.md, Contact.
#include "gpu/index.wgsl"
#include "state/pair_holds.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/relative_velocity.wgsl"
#include "contact/proximity/cones.wgsl"
#include "contact/proximity/history.wgsl"
//                                                                                  elements      unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       previous   : array<vec4f>;        // vertex_count  m; w: 1/kg
@group(0) @binding(2) var<storage, read_write> velocity   : array<atomic<u32>>;  // 4 * vertex_count  m/s, bits of f32
@group(0) @binding(3) var<storage, read>       points     : array<vec4f>;        // of colliders: move_points.wgsl
@group(0) @binding(4) var<storage, read_write> contacts   : array<Contact>;
@group(0) @binding(5) var<storage, read>       statistics : array<u32>;
@group(0) @binding(6) var<storage, read>       rings      : array<u32>;          // feature_rings.hpp
@group(0) @binding(7) var<storage, read_write> pair_holds : array<PairHold>;
@group(0) @binding(8) var<storage, read_write> pair_sums  : array<atomic<u32>>;  // state/pair_holds.wgsl

fn hold_of(number : u32, tangled : bool) -> PairHold {
  var hold : PairHold;
  let ids = contacts[number].ids;
  let thickness = contacts[number].thickness;
  if ((contacts[number].other_end & kOfOneSystem) == 0u || is_crossing(ids) || thickness <= 0.0) { return hold; }
  if (tangled && contacts[number].urgency == 0.0) { return hold; }  // it may be on the wrong side
  let measured = measure(ids, contacts[number].other_end);
  if (!measured.counts || measured.gap <= 0.0) { return hold; }
  let w = weights_of(ids, measured.s, measured.t);
  let way = step.time.dt * dot(measured.normal, relative_velocity(ids, w, measured).velocity);
  if (!(measured.gap + min(way, 0.0) < kContactTouching * thickness)) { return hold; }
  if (!lies_in_cones(ids, measured)) { return hold; }
  let kept = contacts[number].force.xyz;
  let friction = contacts[number].surface.w;
  hold.ids = ids;
  hold.normal = vec4f(measured.normal, 1.0);
  hold.along = vec4f(kept, 0.0);
  hold.force = vec4f(0.0, 0.0, 0.0, friction);
  hold.place = vec4f(measured.s, measured.t, 0.0, thickness - measured.gap);
  hold.start.w = thickness;
  return hold;
}

@compute @workgroup_size(kWorkgroupSize)
fn press_pairs(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let count = select(min(statistics[kStatNear], arrayLength(&contacts)), 0u, statistics[kStatRolledBack] != 0u);
  let tangled = statistics[kStatCrossingsLeft] != 0u;
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let hold = hold_of(number, tangled);
    contacts[number].held = 0u;
    pair_holds[number] = hold;
    if (hold.normal.w == 0.0) { continue; }
    let w = weights_of(hold.ids, hold.place.x, hold.place.y);
    for (var role = 0u; role < 4u; role++) {
      let vertex = hold.ids[role] & kIdBits;
      // Rounded up: a vertex with any part in a pair has sums, which are read and cleared where this is not 0.
      atomicAdd(&pair_sums[kSumWords * vertex], u32(ceil(kHeldUnits * abs(w[role]))));
      forget_history(vertex);
    }
  }
}
