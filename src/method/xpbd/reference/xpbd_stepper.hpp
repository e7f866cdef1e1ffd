#pragma once

#include "method/stepper.hpp"

namespace weft::reference {

/// The substep of docs/solvers/xpbd.md: springs are projected in the order of their colours.
class XpbdStepper : public Stepper {
 public:
  XpbdStepper(const Model& model, std::uint32_t iterations) : model_(model), iterations_(iterations) {}
  void advance(const Substep& substep) override;

 private:
  const Model& model_;
  std::uint32_t iterations_;
};

}  // namespace weft::reference
