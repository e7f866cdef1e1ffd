// Adds to the sums over a vertex's held pairs. The including kernel binds `pair_sums` as array<atomic<u32>>.
#include "state/pair_holds.wgsl"
fn add_high(word : u32, value : u32) {
  if (value != 0u) { atomicAdd(&pair_sums[word + 1u], value); }
}

// Numbers of 64 bits, what is less than 0 as its two's complement. The low words of all axes are in flight at once.
fn add_pair_sum(vertex : u32, value : vec3f) {
  let word = sum_word(vertex);
  let units = round(kSumUnits * min(abs(value), vec3f(kMostSum)));
  let size_high = vec3u(floor(units / 0x1p32));
  let size_low = vec3u(units - vec3f(size_high) * 0x1p32);
  let negative = value < vec3f(0.0);
  let ones = select(vec3u(0u), vec3u(0xffffffffu), negative);
  let low = select(size_low, ~size_low + 1u, negative);
  let high = (size_high ^ ones) + select(vec3u(0u), vec3u(1u), negative & (size_low == vec3u(0u)));
  let before = vec3u(atomicAdd(&pair_sums[word], low.x), atomicAdd(&pair_sums[word + 2u], low.y),
                     atomicAdd(&pair_sums[word + 4u], low.z));
  let more = high + select(vec3u(0u), vec3u(1u), before + low < before);
  add_high(word, more.x);
  add_high(word + 2u, more.y);
  add_high(word + 4u, more.z);
}
