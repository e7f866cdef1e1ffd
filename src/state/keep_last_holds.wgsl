// As keep_last_good, of other words of the state: the forces that hold vertices at obstacles, which are at the
// beginning of `presses`, those of rigid bodies, and what facets keep of their bends. One invocation per word.
#include "gpu/index.wgsl"
#include "state/statistics.wgsl"
//                                                                              elements
@group(0) @binding(0) var<storage, read_write> presses    : array<i32>;      // contact/proximity/press_sums.wgsl
@group(0) @binding(1) var<storage, read_write> good       : array<i32>;      // kHoldWords * vertex_count
@group(0) @binding(2) var<storage, read>       statistics : array<u32>;      // see state/statistics.wgsl

@compute @workgroup_size(kWorkgroupSize)
fn keep_last_holds(@builtin(global_invocation_id) id : vec3u) {
  let word = flat_index(id);
  if (word >= arrayLength(&good)) { return; }
  if ((statistics[kStatNonfinite] | statistics[kStatRolledBack]) == 0u) {
    good[word] = presses[word];
  } else {
    presses[word] = good[word];
  }
}
