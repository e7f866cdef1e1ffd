#pragma once

#include "element/incidence.hpp"
#include "method/reference_ways.hpp"
#include "method/vbd/node_colors.hpp"

namespace weft::reference {

/// The substep of docs/solvers/vbd.md: nodes descend in the order of their colours.
class VbdStepper : public Stepper {
 public:
  VbdStepper(const Model& model, std::uint32_t iterations);
  void advance(const Substep& substep) override;
  void forget() override { look_back_.forget(); }
  void forget(std::size_t node) override { look_back_.forget(node); }

 private:
  std::uint32_t iterations_;
  std::vector<std::uint32_t> order_;  // of all nodes, in a sweep
  mesh::Adjacency springs_of_;        // node -> its springs
  LookBack look_back_;
};

}  // namespace weft::reference
