// Reads and clears the sums over a vertex's held pairs. The including kernel binds `pair_sums` as array<u32>.
#include "state/pair_holds.wgsl"
fn is_held_by_pairs(vertex : u32) -> bool { return pair_sums[kSumWords * vertex] != 0u; }

fn number_of(low : u32, high : u32) -> f32 {
  let negative = (high & 0x80000000u) != 0u;
  let size_low = select(low, ~low + 1u, negative);
  let size_high = select(high, ~high + select(0u, 1u, low == 0u), negative);
  let size = (f32(size_high) * 0x1p32 + f32(size_low)) / kSumUnits;
  return select(size, -size, negative);
}

fn take_pair_sum(vertex : u32) -> vec3f {
  let word = sum_word(vertex);
  var sum : vec3f;
  for (var axis = 0u; axis < 3u; axis++) {
    sum[axis] = number_of(pair_sums[word + 2u * axis], pair_sums[word + 2u * axis + 1u]);
    pair_sums[word + 2u * axis] = 0u;
    pair_sums[word + 2u * axis + 1u] = 0u;
  }
  return sum;
}
