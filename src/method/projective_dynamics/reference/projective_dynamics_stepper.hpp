#pragma once

#include "method/projective_dynamics/relaxation.hpp"
#include "method/reference_ways.hpp"

namespace weft::reference {

/// The substep of docs/solvers/projective_dynamics.md. `step` is the length that its weights are for [s].
class ProjectiveDynamicsStepper : public Stepper {
 public:
  ProjectiveDynamicsStepper(const Model& model, double step, std::uint32_t iterations);
  void advance(const Substep& substep) override;
  void forget() override { look_back_.forget(); }
  void forget(std::size_t node) override { look_back_.forget(node); }

 private:
  std::vector<SpringRates> rates_of_;  // of each node: its cloth's
  Relaxation relaxation_;
  LookBack look_back_;
};

}  // namespace weft::reference
