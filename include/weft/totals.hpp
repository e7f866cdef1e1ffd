// Made by scripts/make_statistics.py from src/state/statistics.txt.
#pragma once

#include <cstdint>
#include <type_traits>

namespace weft {

/// What the frames so far have reported.
struct Totals {
  /// Frames that have reported, but for one that diverged.
  std::uint32_t frames = 0;
  /// Frames that were run again with longer lists or more iterations.
  std::uint32_t repeated_frames = 0;
  /// Narrow-phase hits, summed over substeps.
  std::uint64_t contacts = 0;
  /// Wrapping sum of hash_pair over all hits: the same for every method that finds the same.
  std::uint32_t contact_hash = 0;
  /// The largest length of a triangle's edge over its rest length, at the end of a frame, the most of any.
  float max_stretch = 0;
  /// Contacts that a list had no room for; anything but 0 means that contact is incomplete.
  std::uint64_t contact_overflow = 0;
  /// Searches for pairs of features (proximity).
  std::uint64_t detections = 0;
  /// Edges through triangles that they do not touch at rest, the most of a search (proximity), the most of any.
  std::uint32_t crossings = 0;
  /// Vertices truncated by contact, summed over substeps (proximity).
  std::uint64_t truncated = 0;
  /// Of these, vertices that an obstacle has passed since cloth behind them did not give way.
  std::uint64_t driven = 0;
  /// Substeps that ended before their time for all cloth, so that nothing passes through cloth (proximity).
  std::uint64_t slowed = 0;
  /// The time that these were short of.
  double delay_s = 0;
  /// Pairs of features that are listed at the end of a frame (proximity), the most of any.
  std::uint32_t pairs = 0;
  /// Pairs of triangles that the last search of a frame has listed (proximity), the most of any.
  std::uint32_t candidates = 0;
  /// Of the pairs, those near enough to have a record, at the end of a frame (proximity), the most of any.
  std::uint32_t near = 0;
  /// Iterations that the linear systems of a substep took, the most (implicit solver), the most of any.
  std::uint32_t iterations = 0;
  /// The largest part of its residual that a linear system kept (implicit solver), the most of any.
  float residual = 0;
  /// Linear systems that were left with a larger residual than wanted (implicit solver).
  std::uint64_t unsolved = 0;
  /// Tetrahedra with less than a twentieth of their volume, or inside out, at a frame's end, the most of any.
  std::uint32_t flattened = 0;
  /// Nodes that are not finite; 0 but where a run diverged.
  std::uint32_t nonfinite = 0;
  /// Edges through triangles that they do not touch at rest, of the last search (proximity).
  std::uint32_t crossings_left = 0;
};

/// Calls visit(name, value) for each of them, in their order.
template <class AnyTotals, class Visit>
requires std::is_same_v<std::remove_const_t<AnyTotals>, Totals>
void for_each(AnyTotals& totals, Visit&& visit) {
  visit("frames", totals.frames);
  visit("repeated_frames", totals.repeated_frames);
  visit("contacts", totals.contacts);
  visit("contact_hash", totals.contact_hash);
  visit("max_stretch", totals.max_stretch);
  visit("contact_overflow", totals.contact_overflow);
  visit("detections", totals.detections);
  visit("crossings", totals.crossings);
  visit("truncated", totals.truncated);
  visit("driven", totals.driven);
  visit("slowed", totals.slowed);
  visit("delay_s", totals.delay_s);
  visit("pairs", totals.pairs);
  visit("candidates", totals.candidates);
  visit("near", totals.near);
  visit("iterations", totals.iterations);
  visit("residual", totals.residual);
  visit("unsolved", totals.unsolved);
  visit("flattened", totals.flattened);
  visit("nonfinite", totals.nonfinite);
  visit("crossings_left", totals.crossings_left);
}

}  // namespace weft
