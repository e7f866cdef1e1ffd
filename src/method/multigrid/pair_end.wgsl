// The force that each held pair ends with, in its record, and what that takes out of its vertices' velocities.
// Grid-stride loop over the records. Source: docs/solvers/multigrid.md, equation 16a.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "method/multigrid/hold_law.wgsl"
#include "method/multigrid/pairs.wgsl"
#include "state/add_pair_sums.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<uniform>             nodes      : ClothNodes;
@group(0) @binding(2) var<storage, read>       place      : array<vec4f>;      // count           m; w: N/m, 0: fixed
@group(0) @binding(3) var<storage, read>       vectors    : array<vec4f>;      // cloth.wgsl: the finest
@group(0) @binding(4) var<storage, read>       position   : array<vec4f>;      // vertex_count    m; w: 1/kg
@group(0) @binding(5) var<storage, read>       statistics : array<u32>;
@group(0) @binding(6) var<storage, read>       pair_holds : array<PairHold>;
@group(0) @binding(7) var<storage, read_write> contacts   : array<Contact>;
@group(0) @binding(8) var<storage, read_write> pair_sums  : array<atomic<u32>>;

@compute @workgroup_size(kWorkgroupSize)
fn pair_end(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let cloths = arrayLength(&place) / nodes.count;
  let count = record_count();
  let dt = step.time.dt;
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let hold = pair_holds[number];
    if (!is_own(hold, cloths)) { continue; }
    let n = hold.normal.xyz;
    let w = weights_of(hold.ids, hold.place.x, hold.place.y);
    var solution = vec3f(0.0);
    for (var role = 0u; role < 4u; role++) {
      let all = among_all(hold, role);
      if (place[all].w > 0.0) { solution += w[role] * vectors[vector_of(kSolution, all)].xyz; }
    }
    let soft = hold.place.w;
    let restored = hold.force.z;
    let pressed = hold.force.x + hold.normal.w * (hold.force.y - dot(n, solution));
    let borne = max(0.0, pressed - soft * restored);
    let way = hold.start.xyz + solution;
    let reached = reach_of(hold, soft, way);
    let along = no_longer(reached, hold.force.w * borne);
    let slid = no_longer(reach_of(hold, soft, hold.start.xyz), hold.force.w * hold.force.x);
    let more = along - select(slid, reached, hold.along.w > 0.0) + max(0.0, -pressed) * n;
    let moved = way - restored * n;
    let change = no_longer(dt * hold.place.z * more, kMostFreed / dt * length(moved)) - restored / dt * n;
    // What the spring stops alone of two sides that nothing else holds: a blow, and it is over.
    let alone = hold.normal.w * soft / (hold.normal.w + soft);
    let kept = max(0.0, borne - alone * max(0.0, hold.start.w));
    contacts[number].force = vec4f(kept * n + no_longer(along, hold.force.w * kept), 0.0);
    contacts[number].held = select(0u, kSolved, borne > 0.0);
    let of_two = (contacts[number].other_end & kOfTwoBodies) != 0u;
    for (var role = 0u; role < 4u; role++) {
      let vertex = hold.ids[role] & kIdBits;
      if (place[among_all(hold, role)].w == 0.0) { continue; }
      if (of_two) { atomicStore(&pair_sums[kSumWords * vertex + kOfOtherWord], 1u); }
      add_pair_sum(vertex, (w[role] * position[vertex].w / hold.place.z) * change);
    }
  }
}
