// Enters the kept forces in their hash table. Grid-stride loop over them.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             step        : StepBlock;
@group(0) @binding(1) var<storage, read>       statistics  : array<u32>;
@group(0) @binding(2) var<storage, read>       kept        : array<u32>;          // kept_forces.wgsl
@group(0) @binding(3) var<storage, read_write> kept_places : array<atomic<u32>>;  // a power of two

@compute @workgroup_size(kWorkgroupSize)
fn place_kept_forces(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let list = select(1u, 0u, step.contact.detect == kDetectAlways);
  let count = select(0u, kept[list], statistics[kStatDue] != 0u);
  let last = arrayLength(&kept_places) - 1u;
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    let word = kept_word(list, number);
    var place = hash_of(vec4u(kept[word], kept[word + 1u], kept[word + 2u], kept[word + 3u])) & last;
    loop {
      let tried = atomicCompareExchangeWeak(&kept_places[place], 0u, number + 1u);
      if (tried.exchanged) { break; }
      if (tried.old_value != 0u) { place = (place + 1u) & last; }  // else it failed for no reason: once more
    }
  }
}
