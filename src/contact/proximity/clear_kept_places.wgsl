// Empties the hash table of kept forces before a search. Grid-stride loop over its places.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
//                                                                            elements
@group(0) @binding(0) var<storage, read>       statistics : array<u32>;
@group(0) @binding(1) var<storage, read_write> kept       : array<u32>;  // kept_forces.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn clear_kept_places(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let end = select(0u, arrayLength(&kept), statistics[kStatDue] != 0u);
  for (var word = first_place(kept[kKeptRoomWord]) + id.x; word < end; word += groups.x * kWorkgroupSize) {
    kept[word] = 0u;
  }
}
