// Empties the list of kept forces that `keep_forces` fills next. One invocation.
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
#include "contact/proximity/kept_list.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       statistics : array<u32>;
@group(0) @binding(2) var<storage, read_write> kept       : array<u32>;  // kept_forces.wgsl
override kList : u32 = 0;  // 0: at the end of a frame; 1: before a search within a frame

@compute @workgroup_size(1)
fn begin_keeping() {
  // No branch on the uniform, for which lavapipe would compile the kernel again in each substep.
  let searches = (statistics[kStatDue] != 0u) & (kept_list() == 1u);
  let works = (statistics[kStatRolledBack] == 0u) & ((kList == 0u) | searches);
  kept[kList] = select(kept[kList], 0u, works);
}
