// How much of the substep passes for all cloth, where the last round that holds it back finds what may still meet. The
// including kernel declares `statistics` as atomics. Source: docs/contact.md, equation (6h).
#include "state/statistics.wgsl"

// How much of a way brings what is `now` to `least`, if all of it brings it to `then`.
fn part_until(now : f32, then : f32, least : f32) -> f32 {
  return select(clamp((now - least) / (now - then), 0.0, 1.0), 1.0, then >= least);
}
fn slow_all(part : f32) { atomicMax(&statistics[kStatSlowPart], ~bitcast<u32>(part)); }
// 0: what crosses is driven apart in every substep, whether it goes anywhere or not.
fn part_of_all() -> f32 {
  let found = atomicLoad(&statistics[kStatSlowPart]);
  return select(0.0, bitcast<f32>(~found), found != 0u && atomicLoad(&statistics[kStatCrossingsLeft]) == 0u);
}
