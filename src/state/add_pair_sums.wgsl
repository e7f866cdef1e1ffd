// Adds to the sums over a vertex's held pairs. The including kernel binds `pair_sums` as array<atomic<u32>>.
#include "state/pair_holds.wgsl"
#include "state/wide.wgsl"
fn add_high(word : u32, value : u32) {
  if (value != 0u) { atomicAdd(&pair_sums[word + 1u], value); }
}

// The low words of all axes are in flight at once.
fn add_pair_sum(vertex : u32, value : vec3f) {
  let word = sum_word(vertex);
  let wide = wide_of(value, kSumUnits, kMostSum);
  let before = vec3u(atomicAdd(&pair_sums[word], wide.low.x), atomicAdd(&pair_sums[word + 2u], wide.low.y),
                     atomicAdd(&pair_sums[word + 4u], wide.low.z));
  let more = wide.high + select(vec3u(0u), vec3u(1u), before + wide.low < before);
  add_high(word, more.x);
  add_high(word + 2u, more.y);
  add_high(word + 4u, more.z);
}
