// Empties the hash table of kept forces before a search. Grid-stride loop over its places.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
//                                                                            elements
@group(0) @binding(0) var<storage, read>       statistics  : array<u32>;
@group(0) @binding(1) var<storage, read_write> kept_places : array<u32>;  // a power of two: kept_forces.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn clear_kept_places(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let count = select(0u, arrayLength(&kept_places), statistics[kStatDue] != 0u);
  for (var place = id.x; place < count; place += groups.x * kWorkgroupSize) { kept_places[place] = 0u; }
}
