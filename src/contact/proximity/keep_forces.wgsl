// Keeps the forces of the pairs that act. Grid-stride loop over the records. Source: docs/contact.md, Impulse.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
#include "contact/proximity/kept_list.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       contacts   : array<Contact>;
@group(0) @binding(2) var<storage, read>       statistics : array<u32>;
@group(0) @binding(3) var<storage, read_write> kept       : array<atomic<u32>>;  // kept_forces.wgsl
override kList : u32 = 0;  // 0: at the end of a frame; 1: before a search within a frame

@compute @workgroup_size(kWorkgroupSize)
fn keep_forces(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let searches = (statistics[kStatDue] != 0u) & (kept_list() == 1u);
  let works = (statistics[kStatRolledBack] == 0u) & ((kList == 0u) | searches);
  let near = select(statistics[kStatNear], statistics[kStatNearBefore], kList != 0u);
  let count = select(0u, near, works);
  let room = atomicLoad(&kept[kKeptRoomWord]);
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let force = contacts[number].force.xyz;
    let solved = contacts[number].held == kSolved;
    if (all(force == vec3f(0.0))) { continue; }
    let word = kept_word(room, kList, atomicAdd(&kept[kList], 1u));
    let ids = contacts[number].ids;
    for (var k = 0u; k < 4u; k++) { atomicStore(&kept[word + k], ids[k]); }
    for (var k = 0u; k < 3u; k++) { atomicStore(&kept[word + 4u + k], bitcast<u32>(force[k])); }
    atomicStore(&kept[word + 7u], select(0u, 1u, solved && kList != 0u));
  }
}
