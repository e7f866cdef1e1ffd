#pragma once

#include <array>
#include <vector>

#include "element/spring/neighbours.hpp"
#include "gpu/dispatch.hpp"
#include "method/projective_dynamics/relaxation.hpp"
#include "method/solver.hpp"

namespace weft {

/// Mirror: src/method/projective_dynamics/relaxed_nodes.wgsl.
struct RelaxedNodes {
  std::uint32_t first_node = 0, count = 0;
  float stiffness_rate = 0;  // [1/s²]
  float damping_rate = 0;    // [1/s]
  float radius = 0;
  float padding[3] = {};
  std::array<Vec4f, kNeighbourKinds> kinds = {};
};
static_assert(sizeof(RelaxedNodes) == 32 + 16 * kNeighbourKinds);

/// Mirror: src/method/projective_dynamics/relax_nodes.wgsl.
struct Iteration {
  float weight = 1;
  float padding[3] = {};
};
static_assert(sizeof(Iteration) == 16);

/// Cloth by projective dynamics: in each of a substep's cycles springs are projected, and their global system is
/// relaxed. Source: docs/solvers/projective_dynamics.md.
class SolverProjectiveDynamics : public Solver {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Solver>> create(const scene::Solver& settings, const SolverInputs& inputs);

  void record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t count) const override;

 private:
  /// What a cloth's nodes are relaxed by.
  struct Cloth {
    std::uint32_t count = 0;  // of nodes
    gpu::Buffer<std::uint32_t> slices;
    gpu::Buffer<Neighbour> neighbours;
    gpu::Buffer<RelaxedNodes> nodes;
    std::vector<gpu::Dispatch> iterations;  // of all cycles, in their order
  };
  Result<void> create_nodes(const SolverInputs& inputs);
  Result<void> create_cloth(const SolverInputs& inputs, const Body& body, const SpringRates& rates);
  Result<gpu::Dispatch> create_projection(const SolverInputs& inputs, const Cloth& cloth,
                                          std::size_t cycle) const;
  Result<gpu::Dispatch> create_iteration(const SolverInputs& inputs, const Cloth& cloth, std::size_t cycle,
                                         std::size_t iteration) const;
  /// The ways after so many cycles. The last are in position[1 - parity], where a substep ends.
  const gpu::Buffer<Vec4f>& ways_after(std::size_t cycle, const State& state, std::size_t parity) const {
    return (relaxation_.cycles.size() - cycle) % 2 == 0 ? state.position[1 - parity] : way_;
  }

  Relaxation relaxation_;
  std::vector<Cloth> cloths_;
  std::vector<std::vector<gpu::Buffer<Iteration>>> weights_;  // of each cycle's iterations after the first
  gpu::Buffer<Vec4f> aim_;                                    // the way of each node without springs [m]
  gpu::Buffer<Vec4f> way_;                                    // every second cycle's
  gpu::Buffer<Vec4f> left_;                                   // of the global system [m]
  std::array<gpu::Buffer<Vec4f>, 2> change_;                  // of the way, in turns [m]
  gpu::Buffer<std::uint32_t> corners_;  // src/method/air.wgsl; without air one number, which is not read

  gpu::Dispatch start_way_, end_way_;
};

}  // namespace weft
