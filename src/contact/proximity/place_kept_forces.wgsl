// Enters the kept forces in their hash table. Grid-stride loop over them.
#include "gpu/index.wgsl"
#include "state/step.wgsl"
#include "state/statistics.wgsl"
#include "contact/proximity/kept_forces.wgsl"
#include "contact/proximity/kept_list.wgsl"
//                                                                            elements
@group(0) @binding(0) var<uniform>             step       : StepBlock;
@group(0) @binding(1) var<storage, read>       statistics : array<u32>;
@group(0) @binding(2) var<storage, read_write> kept       : array<atomic<u32>>;  // kept_forces.wgsl

fn kept_ids(word : u32) -> vec4u {
  return vec4u(atomicLoad(&kept[word]), atomicLoad(&kept[word + 1u]), atomicLoad(&kept[word + 2u]),
               atomicLoad(&kept[word + 3u]));
}

@compute @workgroup_size(kWorkgroupSize)
fn place_kept_forces(@builtin(global_invocation_id) id : vec3u, @builtin(num_workgroups) groups : vec3u) {
  let list = kept_list();
  let count = select(0u, atomicLoad(&kept[list]), statistics[kStatDue] != 0u);
  let room = atomicLoad(&kept[kKeptRoomWord]);
  let first = first_place(room);
  let last = arrayLength(&kept) - first - 1u;
  for (var number = id.x; number < count; number += groups.x * kWorkgroupSize) {
    var place = hash_of(kept_ids(kept_word(room, list, number))) & last;
    loop {
      let tried = atomicCompareExchangeWeak(&kept[first + place], 0u, number + 1u);
      if (tried.exchanged) { break; }
      if (tried.old_value != 0u) { place = (place + 1u) & last; }  // else it failed for no reason: once more
    }
  }
}
