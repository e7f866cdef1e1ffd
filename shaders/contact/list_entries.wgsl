// Enters every pair with each of its cloth vertices, in whatever order invocations come. An invocation takes every
// so-manieth pair, since the host does not know how many there are.
#include "shared/index.wgsl"
#include "shared/contact.wgsl"
#include "shared/statistics.wgsl"
struct EntryParams {  // mirror: src/collision/contact_lists.hpp
  vertex_count : u32,
}
//                                                                                    elements
@group(0) @binding(0) var<uniform>             params          : EntryParams;
@group(0) @binding(1) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(2) var<storage, read>       contacts        : array<Contact>;
@group(0) @binding(3) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(4) var<storage, read_write> entries         : array<u32>;

@compute @workgroup_size(kWorkgroupSize)
fn list_entries(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  if (statistics[kStatDue] == 0u) { return; }
  let count = statistics[kStatPairs];
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role])) { continue; }
      let vertex = ids[role] & kIdBits;
      let begin = atomicLoad(&vertex_contacts[kVertexWords * vertex]) +
                  atomicLoad(&vertex_contacts[kVertexWords * params.vertex_count + vertex / kScanBlock]);
      // Counts down what find_pairs has counted; sort_entries puts the number back.
      entries[begin + atomicSub(&vertex_contacts[kVertexWords * vertex + 1u], 1u) - 1u] = 16u * pair + role;
    }
  }
}
