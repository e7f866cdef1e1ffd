// Reads and clears the sums over a vertex's held pairs. The including kernel binds `pair_sums` as array<u32>.
#include "state/pair_holds.wgsl"
#include "state/wide.wgsl"
fn is_held_by_pairs(vertex : u32) -> bool { return pair_sums[kSumWords * vertex] != 0u; }

fn take_pair_sum(vertex : u32) -> vec3f {
  let word = sum_word(vertex);
  var sum : vec3f;
  for (var axis = 0u; axis < 3u; axis++) {
    sum[axis] = number_of(pair_sums[word + 2u * axis], pair_sums[word + 2u * axis + 1u], kSumUnits);
    pair_sums[word + 2u * axis] = 0u;
    pair_sums[word + 2u * axis + 1u] = 0u;
  }
  return sum;
}
