// The substep of methods that move ways, in double: what src/method/way_velocity.wgsl and end_way.wgsl do.
#pragma once

#include <vector>

#include "method/stepper.hpp"

namespace weft::reference {

/// What moves in a substep: ways from the places at its start.
struct Ways {
  std::vector<Vec3d> start;          // [m]
  std::vector<Vec3d> way;            // [m]
  std::vector<double> inverse_mass;  // 0: prescribed [1/kg]

  Vec3d place(std::size_t node) const { return start[node] + way[node]; }

  /// The ways of a substep without its elements.
  static Ways begin(const Substep& substep);
  /// Where the ways have taken every node, and the velocities that this is.
  void end(const Substep& substep) const;
};

}  // namespace weft::reference
