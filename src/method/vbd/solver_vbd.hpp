#pragma once

#include <array>
#include <vector>

#include "element/spring/neighbours.hpp"
#include "gpu/dispatch.hpp"
#include "method/pieces/piece_motion.hpp"
#include "method/solver.hpp"
#include "method/vbd/descend_fabric.hpp"
#include "method/vbd/descend_solid.hpp"
#include "method/ways.hpp"

namespace weft {

/// Mirror: src/method/vbd/descend.wgsl.
struct NodesOfColor {
  std::uint32_t first = 0, count = 0;
  std::uint32_t first_node = 0;
  std::uint32_t padding = 0;
  std::array<Vec4f, kNeighbourKinds> kinds = {};
};
static_assert(sizeof(NodesOfColor) == 16 + 16 * kNeighbourKinds);

/// Cloth by vertex block descent: nodes descend one after the other, colour after colour. Source: docs/solvers/vbd.md.
class SolverVbd : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const scene::Solver& settings, const SolverInputs& inputs);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  /// What the nodes of a cloth of springs descend by.
  struct Cloth {
    gpu::Buffer<std::uint32_t> order, slices;
    gpu::Buffer<Neighbour> neighbours;
    std::vector<gpu::Buffer<NodesOfColor>> colors;
  };
  Result<void> create_nodes(const SolverInputs& inputs);
  Result<void> create_springs(const SolverInputs& inputs, const Body& body);

  std::vector<Cloth> cloths_;  // of springs
  std::vector<DescendFabric> fabrics_;
  std::vector<DescendSolid> solids_;
  PieceMotion pieces_;
  gpu::Buffer<Vec4f> aim_;  // the way of each node without springs [m]; node_holds.wgsl
  GasOnWays gas_;
  gpu::Buffer<std::uint32_t> corners_;  // src/method/corners.wgsl; without air one number, which is not read

  // While nodes descend, position[1 - parity] holds ways from position[parity], not places.
  gpu::Dispatch start_way_, begin_holds_, end_way_;
  std::vector<gpu::Dispatch> sweep_;  // a dispatch a colour of each cloth of springs
  std::uint32_t iterations_ = 1;
};

}  // namespace weft
