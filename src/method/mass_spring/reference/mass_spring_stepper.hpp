#pragma once

#include "method/stepper.hpp"

namespace weft::reference {

/// Semi-implicit Euler, then nodes that follow a motion are taken to their places.
class MassSpringStepper : public Stepper {
 public:
  explicit MassSpringStepper(const Model& model) : motion_(model.motion) {}
  void advance(const Substep& substep) override;

 private:
  const std::vector<std::uint32_t>& motion_;  // Model::motion
};

}  // namespace weft::reference
