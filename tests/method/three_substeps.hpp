// Three substeps of a method that looks back on the one before, against the same in double: the second and third do.
#pragma once

#include <algorithm>

#include "solver_rig.hpp"

namespace weft {

inline constexpr double kUlp = 1.0 / 16777216;  // 2^-24: a relative rounding error of f32

/// `roundings`: those of a spring's length by which a substep may place a node wrong.
inline void check_three_substeps(SolverRig& rig, const scene::Scene& scene, double roundings) {
  constexpr int kSteps = 3;
  const std::vector<Vec3d> start = rig.reference().position;
  const reference::MassSpringSystem exact = exact_after(rig, scene, kSteps);
  double longest = 0;
  for (const auto& s : exact.springs)
    longest = std::max({longest, s.rest_length, length(start[s.node_b] - start[s.node_a])});
  rig.advance(kSteps);
  const auto position = rig.positions();
  double way = 0, worst = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    way = std::max(way, length(exact.position[i] - start[i]));
    worst = std::max(worst, length(position[i].xyz().to<double>() - exact.position[i]));
  }
  // What a step is off its velocity carries on: 1 + 2 + 3 of them. A place of less than 4 m rounds in each.
  const double tolerance = 6 * roundings * kUlp * longest + kSteps * 4 * kUlp;
  MESSAGE(position.size() << " nodes: " << worst << " m off after a way of " << way << " m; allowed "
                          << tolerance << " m");
  CHECK(worst < tolerance);
  CHECK(tolerance < 0.01 * way);  // a spring that is left out, or a weight, is seen
}

}  // namespace weft
