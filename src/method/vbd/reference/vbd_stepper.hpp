#pragma once

#include <optional>

#include "element/incidence.hpp"
#include "method/holds/reference/node_hold.hpp"
#include "method/pieces/free_pieces.hpp"
#include "method/reference_ways.hpp"
#include "method/vbd/node_colors.hpp"
#include "method/vbd/reference/fabric_descent.hpp"
#include "method/vbd/reference/solid_descent.hpp"

namespace weft::reference {

/// The substep of docs/solvers/vbd.md: nodes descend in the order of their colours.
class VbdStepper : public Stepper {
 public:
  VbdStepper(const Model& model, std::uint32_t iterations);
  void advance(const Substep& substep) override;
  void forget() override { look_back_.forget(); }
  void forget(std::size_t node) override { look_back_.forget(node); }
  std::vector<bool> held() const override { return holds_.held(); }

 private:
  /// A body's nodes in the order of a sweep, and where it has no springs, what they descend by.
  struct Cloth {
    std::vector<std::uint32_t> order;
    std::optional<FabricDescent> fabric;
    std::optional<SolidDescent> solid;
  };
  void sweep(const Substep& substep, const std::vector<Vec3d>& aim, Ways& ways);

  std::uint32_t iterations_;
  std::vector<Cloth> cloths_;
  mesh::Adjacency springs_of_;  // node -> its springs
  FreePieces pieces_;
  LookBack look_back_;
  NodeHolds holds_;
};

}  // namespace weft::reference
