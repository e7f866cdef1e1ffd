// Made by scripts/make_statistics.py from src/state/statistics.txt.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "weft/totals.hpp"

namespace weft {

/// What a frame reports. Mirror of src/state/statistics.wgsl.
struct Statistics {
  /// Narrow-phase hits, summed over substeps.
  std::uint32_t contacts = 0;
  /// Wrapping sum of hash_pair over all hits: the same for every method that finds the same.
  std::uint32_t contact_hash = 0;
  /// The largest length of a triangle's edge over its rest length, at the end of a frame.
  float max_stretch = 0;
  /// Contacts that a list had no room for; anything but 0 means that contact is incomplete.
  std::uint32_t contact_overflow = 0;
  /// Searches for pairs of features (proximity).
  std::uint32_t detections = 0;
  /// Edges through triangles that they do not touch at rest, the most of a search (proximity).
  std::uint32_t crossings = 0;
  /// Vertices truncated by contact, summed over substeps (proximity).
  std::uint32_t truncated = 0;
  /// Of these, vertices that an obstacle has passed since cloth behind them did not give way.
  std::uint32_t driven = 0;
  /// Substeps that ended before their time for all cloth, so that nothing passes through cloth (proximity).
  std::uint32_t slowed = 0;
  /// The time that these were short of.
  std::uint32_t delay_us = 0;
  /// Pairs of features that are listed at the end of a frame (proximity).
  std::uint32_t pairs = 0;
  /// Pairs of triangles that the last search of a frame has listed (proximity).
  std::uint32_t candidates = 0;
  /// Of the pairs, those near enough to have a record, at the end of a frame (proximity).
  std::uint32_t near = 0;
  /// Iterations that the linear systems of a substep took, the most (implicit solver).
  std::uint32_t iterations = 0;
  /// Iterations of the last linear system of a substep, the most (implicit solver).
  std::uint32_t corrections = 0;
  /// The largest part of its residual that a linear system kept (implicit solver).
  float residual = 0;
  /// Linear systems that were left with a larger residual than wanted (implicit solver).
  std::uint32_t unsolved = 0;
  /// 1: in a substep cloth was pressed, and impulses took all their iterations (proximity).
  std::uint32_t pressing = 0;
  /// Tetrahedra with less than a twentieth of their volume, or inside out, at a frame's end.
  std::uint32_t flattened = 0;
  /// Nodes that are not finite; 0 but where a run diverged.
  std::uint32_t nonfinite = 0;
  /// 1 once the state is frozen at the last good frame.
  std::uint32_t frozen = 0;
  /// 1 once a list was too short: the state is as before the frame until the list is longer.
  std::uint32_t rolled_back = 0;
  /// 1: a vertex is about to leave its reach.
  std::uint32_t detect = 0;
  /// 1: a search is under way.
  std::uint32_t due = 0;
  /// Edges through triangles that they do not touch at rest, of the last search (proximity).
  std::uint32_t crossings_left = 0;
  /// Near pairs before the search that is under way.
  std::uint32_t near_before = 0;
  /// 1: some vertex goes farther than to the obstacles that have records (proximity).
  std::uint32_t far_ways = 0;
  /// The last round of a substep in which cloth could meet other cloth on its way; 0: none.
  std::uint32_t meeting = 0;
  /// That time in the frame's substeps before this one, in microseconds.
  std::uint32_t delay_before = 0;
  /// The bits, inverted, of the part that all cloth may go of its ways; 0: all.
  std::uint32_t slow_part = 0;
  /// Of a substep, kPressedOften times the pairs of cloth that are pressed less those that act, as i32.
  std::uint32_t pressed = 0;
  /// How far a collider may go until the next search [m].
  float reach = 0;
  /// How far one may have gone since this search [m].
  float travel = 0;
  /// How far a rigid body may go in this substep [m].
  float body_travel = 0;
};
static_assert(sizeof(Statistics) == 34 * sizeof(std::uint32_t));

/// The part that is cleared before each frame.
inline constexpr std::uint32_t kStatisticsPerFrameBytes = offsetof(Statistics, nonfinite);

/// Takes what a frame has reported into the totals.
inline void add(Totals& totals, const Statistics& frame) {
  totals.contacts += frame.contacts;
  totals.contact_hash += frame.contact_hash;
  totals.max_stretch = std::max(totals.max_stretch, frame.max_stretch);
  totals.contact_overflow += frame.contact_overflow;
  totals.detections += frame.detections;
  totals.crossings = std::max(totals.crossings, frame.crossings);
  totals.truncated += frame.truncated;
  totals.driven += frame.driven;
  totals.slowed += frame.slowed;
  totals.delay_s = (std::round(1e6 * totals.delay_s) + frame.delay_us) / 1e6;
  totals.pairs = std::max(totals.pairs, frame.pairs);
  totals.candidates = std::max(totals.candidates, frame.candidates);
  totals.near = std::max(totals.near, frame.near);
  totals.iterations = std::max(totals.iterations, frame.iterations);
  totals.residual = std::max(totals.residual, frame.residual);
  totals.unsolved += frame.unsolved;
  totals.flattened = std::max(totals.flattened, frame.flattened);
  totals.nonfinite = frame.nonfinite;
  totals.crossings_left = frame.crossings_left;
}

/// Calls visit(name, value) for each word, in their order.
template <class Visit>
void for_each(const Statistics& statistics, Visit&& visit) {
  visit("contacts", statistics.contacts);
  visit("contact_hash", statistics.contact_hash);
  visit("max_stretch", statistics.max_stretch);
  visit("contact_overflow", statistics.contact_overflow);
  visit("detections", statistics.detections);
  visit("crossings", statistics.crossings);
  visit("truncated", statistics.truncated);
  visit("driven", statistics.driven);
  visit("slowed", statistics.slowed);
  visit("delay_us", statistics.delay_us);
  visit("pairs", statistics.pairs);
  visit("candidates", statistics.candidates);
  visit("near", statistics.near);
  visit("iterations", statistics.iterations);
  visit("corrections", statistics.corrections);
  visit("residual", statistics.residual);
  visit("unsolved", statistics.unsolved);
  visit("pressing", statistics.pressing);
  visit("flattened", statistics.flattened);
  visit("nonfinite", statistics.nonfinite);
  visit("frozen", statistics.frozen);
  visit("rolled_back", statistics.rolled_back);
  visit("detect", statistics.detect);
  visit("due", statistics.due);
  visit("crossings_left", statistics.crossings_left);
  visit("near_before", statistics.near_before);
  visit("far_ways", statistics.far_ways);
  visit("meeting", statistics.meeting);
  visit("delay_before", statistics.delay_before);
  visit("slow_part", statistics.slow_part);
  visit("pressed", statistics.pressed);
  visit("reach", statistics.reach);
  visit("travel", statistics.travel);
  visit("body_travel", statistics.body_travel);
}

}  // namespace weft
