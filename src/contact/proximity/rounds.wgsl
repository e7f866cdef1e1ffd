// The rounds of a substep, and when they have something to do: kStatMeeting has the number of the last one that had.
// The including kernel binds `this_round`, and `statistics` as atomics. Mirror: Round in
// src/contact/proximity/round_kernel.hpp.
#include "state/statistics.wgsl"
struct Round {
  number : u32,
  is_first : u32,  // 1: of those that hold back
  is_last : u32,   // 1: of those that hold back, or of those that shorten ways for edges
  since : u32,     // it asks only if that round or one after it had something to do; 0: always
}

const kBeyond = 1.001;  // of what an edge may be: one that is no longer stays as it is

// Of a kernel that asks what there is to do in a round, and of the one that then `acts` on it.
fn round_is_idle(acts : bool) -> bool {
  return atomicLoad(&statistics[kStatRolledBack]) != 0u ||
         atomicLoad(&statistics[kStatMeeting]) < select(this_round.since, this_round.number, acts);
}
