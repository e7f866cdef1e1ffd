#pragma once

#include <vector>

#include "method/holds/reference/node_hold.hpp"
#include "method/projection/reference/fabric_projection.hpp"
#include "method/projection/reference/solid_projection.hpp"
#include "method/reference_ways.hpp"
#include "method/stepper.hpp"
#include "model/tethers.hpp"

namespace weft::reference {

/// The substep of docs/solvers/xpbd.md, or where multipliers are forgotten that of docs/solvers/pbd.md: elements are
/// projected in the order of their colours.
class ProjectionStepper : public Stepper {
 public:
  ProjectionStepper(const Model& model, std::uint32_t iterations, Multipliers multipliers);
  void advance(const Substep& substep) override;
  std::vector<bool> held() const override { return holds_.held(); }

 private:
  double lengthening(const Ways& ways, std::uint32_t first, std::uint32_t end) const;
  void keep_tethers(Ways& ways) const;
  void project_holds(Ways& ways);

  const Model& model_;
  std::uint32_t iterations_;
  Multipliers multipliers_;
  TetherRows tethers_;
  std::vector<FabricProjection> fabrics_;  // of the bodies that have it
  std::vector<SolidProjection> solids_;    // likewise
  NodeHolds holds_;
};

}  // namespace weft::reference
