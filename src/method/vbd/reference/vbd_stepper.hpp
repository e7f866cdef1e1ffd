#pragma once

#include "element/incidence.hpp"
#include "method/stepper.hpp"
#include "method/vbd/node_colors.hpp"

namespace weft::reference {

/// The substep of docs/solvers/vbd.md: nodes descend in the order of their colours.
class VbdStepper : public Stepper {
 public:
  VbdStepper(const Model& model, std::uint32_t iterations);
  void advance(const Substep& substep) override;
  void forget() override { known_.assign(known_.size(), false); }
  void forget(std::size_t node) override { known_[node] = false; }

 private:
  std::uint32_t iterations_;
  std::vector<std::uint32_t> order_;    // of all nodes, in a sweep
  mesh::Adjacency springs_of_;          // node -> its springs
  std::vector<Vec3d> velocity_before_;  // at the start of the substep before [m/s]
  std::vector<bool> known_;             // whether that is of the motion that goes on
};

}  // namespace weft::reference
