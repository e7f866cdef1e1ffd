// When the rounds of a substep have something to do: kStatMeeting has the number of the last one that had.
// The including kernel declares `statistics` as atomics.
#include "state/statistics.wgsl"

// Of a kernel that asks what there is to do in a round, and of the one that then `acts` on it. The first asks always,
// another one if there was something to do in the round before it.
fn round_is_idle(round : u32, is_first : bool, acts : bool) -> bool {
  let asks = is_first && !acts;
  return atomicLoad(&statistics[kStatRolledBack]) != 0u ||
         (!asks && atomicLoad(&statistics[kStatMeeting]) + select(1u, 0u, acts) < round);
}
