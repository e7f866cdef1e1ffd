// Adds to the sums over a vertex's held pairs. The including kernel binds `pair_sums` as array<atomic<u32>>.
#include "state/pair_holds.wgsl"
fn add_pair_sum(vertex : u32, value : vec3f) {
  let word = sum_word(vertex);
  for (var axis = 0u; axis < 3u; axis++) {
    let units = round(kSumUnits * min(abs(value[axis]), kMostSum));
    if (units == 0.0) { continue; }
    let high = u32(floor(units / 0x1p32));
    let low = u32(units - f32(high) * 0x1p32);
    let at = word + 2u * axis;
    if (value[axis] > 0.0) {
      let before = atomicAdd(&pair_sums[at], low);
      let carry = select(0u, 1u, before + low < before);
      if (high + carry != 0u) { atomicAdd(&pair_sums[at + 1u], high + carry); }
    } else {
      let before = atomicSub(&pair_sums[at], low);
      let borrow = select(0u, 1u, before < low);
      if (high + borrow != 0u) { atomicSub(&pair_sums[at + 1u], high + borrow); }
    }
  }
}
