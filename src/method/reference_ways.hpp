// The substep of methods that move ways, in double: what src/method/way_velocity.wgsl, start_way.wgsl and end_way.wgsl
// do.
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

/// What a substep that seeks its end begins from: docs/solvers/vbd.md, equation 2.
class LookBack {
 public:
  explicit LookBack(std::size_t node_count) : velocity_before_(node_count), known_(node_count, false) {}
  /// The ways to begin from; `aim` gets those without springs.
  Ways begin(const Substep& substep, std::vector<Vec3d>& aim);
  const std::vector<Vec3d>& velocity_before() const { return velocity_before_; }
  const std::vector<bool>& known() const { return known_; }
  void forget() { known_.assign(known_.size(), false); }
  void forget(std::size_t node) { known_[node] = false; }

 private:
  std::vector<Vec3d> velocity_before_;  // at the start of the substep before [m/s]
  std::vector<bool> known_;             // whether that is of the motion that goes on
};

}  // namespace weft::reference
