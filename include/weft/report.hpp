// What a world says of itself.
#pragma once

#include <cstdint>
#include <string>

namespace weft {

/// What was loaded, and what was decided before the first frame.
struct Description {
  std::uint64_t nodes = 0, triangles = 0, springs = 0;  // of all cloths and bodies
  std::uint64_t membranes = 0, hinges = 0;              // of those of fabric
  std::uint64_t slivers = 0;     // of the membranes, those far thinner than a neighbour: they bend freely
  std::uint64_t tetrahedra = 0;  // of bodies
  std::uint64_t dropped_triangles = 0;  // of colliders, since they have no area
  std::string solver;                   // solver.kind; of "auto" the one it chose
  std::string solver_reason;            // why "auto" chose it; empty where the scene did
  std::string solver_settings;          // "node_centric"; empty for a solver without
  std::string contact_method;           // "proximity"
  std::uint32_t frames = 0;             // that the scene asks for
  std::uint32_t substeps = 0;           // of a frame
  double frame_seconds = 0;             // simulated time of a frame [s]
  double step_seconds = 0;              // of a substep [s]
  double stable_step_seconds = 0;       // the longest stable one [s]; 0: any is
  std::string unstable_step;            // a sentence where the step is longer; else empty
};

}  // namespace weft
