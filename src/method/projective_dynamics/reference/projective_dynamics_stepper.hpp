#pragma once

#include "method/holds/reference/node_hold.hpp"
#include "method/pieces/free_pieces.hpp"
#include "method/projective_dynamics/node_pairs.hpp"
#include "method/projective_dynamics/reference/solid_relaxation.hpp"
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
  std::vector<bool> held() const override { return holds_.held(); }

 private:
  /// A cloth of fabric.
  struct Fabric {
    std::uint32_t first = 0;  // of its nodes
    std::vector<NodePair> pairs;
  };
  /// A cycle begins: what elements pull the nodes with at the ways so far [N].
  std::vector<Vec3d> pulls(const MassSpringSystem& system, const Ways& ways, double dt);
  /// By how much those of projected elements grow with a change of the ways, -L change [N].
  std::vector<Vec3d> pulls_of_change(const MassSpringSystem& system, const std::vector<Vec3d>& change,
                                     double dt) const;

  std::vector<ClothRates> rates_of_;     // of each node: its cloth's
  std::vector<Fabric> fabrics_;          // in the order of the system's
  std::vector<SolidRelaxation> solids_;  // likewise
  Relaxation relaxation_;
  FreePieces pieces_;
  LookBack look_back_;
  NodeHolds holds_;
};

}  // namespace weft::reference
