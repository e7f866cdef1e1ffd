// Enters every pair in the list of each of its cloth vertices. Grid-stride loop over the pairs. The order depends on
// scheduling; no result depends on it, since sums over a list are of integers.
#include "gpu/index.wgsl"
#include "state/contact.wgsl"
#include "state/statistics.wgsl"
//                                                                                    elements
@group(0) @binding(0) var<storage, read>       statistics      : array<u32>;
@group(0) @binding(1) var<storage, read_write> contacts        : array<Contact>;
@group(0) @binding(2) var<storage, read_write> vertex_contacts : array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> entries         : array<u32>;  // see state/contact.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn list_entries(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  if (statistics[kStatDue] == 0u || statistics[kStatRolledBack] != 0u) { return; }
  let count = statistics[kStatPairs];
  for (var pair = id.x; pair < count; pair += groups.x * kWorkgroupSize) {
    let ids = contacts[pair].ids;
    for (var role = 0u; role < role_count(ids); role++) {
      if (is_collider(ids[role])) { continue; }
      let word = kVertexWords * (ids[role] & kIdBits);
      let cursor = atomicAdd(&vertex_contacts[word + kCursorWord], 1u) & kCursorBits;
      let slot = atomicLoad(&vertex_contacts[word]) + cursor;
      entries[slot] = kEntryPair * pair + role;
      contacts[pair].slots[role] = slot;
    }
  }
}
