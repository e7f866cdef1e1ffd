// What a world says of itself.
#pragma once

#include <cstdint>
#include <string>

namespace weft {

/// What was loaded, and what was decided before the first frame.
struct Description {
  std::uint64_t nodes = 0, triangles = 0, springs = 0;  // of all cloths
  std::uint64_t dropped_triangles = 0;                  // of colliders, since they have no area
  std::string solver;                                   // solver.kind; of "auto" the one it chose
  std::string solver_reason;                            // why "auto" chose it; empty where the scene did
  std::string solver_settings;                          // "node_centric"; empty for a solver without
  std::string contact_method;                           // "proximity"
  std::uint32_t frames = 0;                             // that the scene asks for
  std::uint32_t substeps = 0;                           // of a frame
  double frame_seconds = 0;                             // simulated time of a frame [s]
  double step_seconds = 0;                              // of a substep [s]
  double stable_step_seconds = 0;                       // the longest stable one [s]; 0: any is
  std::string unstable_step;                            // a sentence where the step is longer; else empty
};

/// What the frames so far have reported.
struct Totals {
  std::uint32_t frames = 0;        // reported
  std::uint64_t contacts = 0;      // narrow-phase hits
  std::uint32_t contact_hash = 0;  // wrapping sum over all hits
  std::uint64_t contact_overflow = 0;
  std::uint64_t detections = 0;       // by proximity: searches for pairs
  std::uint64_t truncated = 0;        // vertices truncated by contact, summed over substeps
  std::uint32_t pairs = 0;            // the most that were listed at the end of a frame
  std::uint32_t candidates = 0;       // likewise, pairs of triangles
  std::uint32_t crossings = 0;        // edges through triangles, the most of any search
  std::uint32_t crossings_left = 0;   // of the last search
  std::uint32_t repeated_frames = 0;  // since a list was too short
  float max_stretch = 0;              // the largest at the end of any frame, length / rest length
  std::uint32_t nonfinite = 0;        // nodes
};

}  // namespace weft
