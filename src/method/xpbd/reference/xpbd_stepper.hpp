#pragma once

#include <vector>

#include "method/stepper.hpp"
#include "method/xpbd/reference/fabric_projection.hpp"

namespace weft::reference {

/// The substep of docs/solvers/xpbd.md: elements are projected in the order of their colours.
class XpbdStepper : public Stepper {
 public:
  XpbdStepper(const Model& model, std::uint32_t iterations);
  void advance(const Substep& substep) override;

 private:
  const Model& model_;
  std::uint32_t iterations_;
  std::vector<FabricProjection> fabrics_;  // of the bodies that have it
};

}  // namespace weft::reference
