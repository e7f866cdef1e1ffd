// Finds the pairs of cloth whose sides may meet on the ways that their vertices go, and marks the vertices: equation
// (6) of docs/contact.md. Grid-stride loop over the pairs. The second round asks the pairs again of which a vertex was
// not held back in the first.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/planes.wgsl"
//                                                                                elements          unit
@group(0) @binding(0) var<uniform>             step            : StepBlock;
@group(0) @binding(1) var<storage, read>       position        : array<vec4f>; // vertex_count      m, where ways end
@group(0) @binding(2) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(3) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> statistics      : array<atomic<u32>>;
override kRound : u32 = 1;
var<workgroup> listed : u32;

@compute @workgroup_size(kWorkgroupSize)
fn find_meeting(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u,
                @builtin(local_invocation_index) thread : u32) {
  if (thread == 0u) {
    let idle = atomicLoad(&statistics[kStatRolledBack]) != 0u ||
               (kRound == 2u && atomicLoad(&statistics[kStatMeeting]) == 0u);
    listed = select(atomicLoad(&statistics[kStatPairs]), 0u, idle);
  }
  let count = workgroupUniformLoad(&listed);
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    if (!is_self_pair(ids) || is_crossing(ids)) { continue; }
    let normal = contacts[pair].normal;
    if (contacts[pair].solid != 0u || normal.w <= 0.0) { continue; }
    var least = 3e38;   // of side A along the normal, m
    var most = -3e38;   // of side B
    var all_held = true;
    for (var role = 0u; role < 4u; role++) {
      let vertex = ids[role] & kIdBits;
      let place = position[vertex];
      let along = dot(normal.xyz, place.xyz);
      if (role < roles_of_a(ids)) { least = min(least, along); } else { most = max(most, along); }
      if (kRound == 2u) {
        let held = atomicLoad(&vertex_contacts[kVertexWords * vertex + kHeldWord]) & kHeld;
        all_held = all_held && (held != 0u || place.w == 0.0);
      }
    }
    if (least - most >= normal.w || (kRound == 2u && all_held)) { continue; }
    if (least - most >= least_apart(normal.w, contacts[pair].thickness)) { continue; }
    for (var role = 0u; role < 4u; role++) {
      atomicOr(&vertex_contacts[kVertexWords * (ids[role] & kIdBits) + kHeldWord], kMarked);
    }
    atomicStore(&statistics[select(kStatMeeting, kStatStillMeeting, kRound == 2u)], 1u);
  }
}
