#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "element/colors.hpp"
#include "method/projection/multipliers.hpp"
#include "method/reference_ways.hpp"
#include "method/stepper.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// The membranes and hinges of a cloth of fabric as constraints, projected colour after colour.
/// Source: docs/solvers/xpbd.md, Fabric.
class FabricProjection {
 public:
  FabricProjection(const Model& model, const Body& body, Multipliers multipliers);

  /// A substep begins: nothing pulls yet.
  void begin();
  /// Forth over hinges, then membranes, and back, in a substep of dt [s]. `cloth` is that of the body.
  void sweep(Ways& ways, const FabricCloth& cloth, double dt);

 private:
  /// In this order.
  void project_hinges(Ways& ways, const FabricCloth& cloth, std::span<const std::uint32_t> order, double dt);
  void project_membrane(Ways& ways, const FabricCloth& cloth, std::uint32_t triangle, double dt);

  Multipliers multipliers_;
  Colors membranes_, hinges_;
  std::vector<double> resistance_;  // of hinges: k̄ [N·m]
  std::vector<Vec3d> strained_,
      damped_;  // multipliers of membranes, and of damping that has strains of its own [kg·m²]
  std::vector<double> bent_;  // of hinges [kg·m²]
};

}  // namespace weft::reference
