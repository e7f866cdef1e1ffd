// What the cloths of a scene are relaxed in and by: the same for springs and fabric.
#pragma once

#include <array>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/holds/held_ways.hpp"
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
};
static_assert(sizeof(RelaxedNodes) == 32);
RelaxedNodes relaxed_nodes(const Body& body, const ClothRates& rates, const Relaxation& relaxation);

/// Mirror: src/method/projective_dynamics/relax.wgsl.
struct Iteration {
  float weight = 1;
  float padding[3] = {};
};
static_assert(sizeof(Iteration) == 16);

/// Nodes of all cloths.
struct RelaxedState {
  Relaxation relaxation;
  std::vector<std::vector<gpu::Buffer<Iteration>>> weights;  // of each cycle's iterations after the first
  gpu::Buffer<Vec4f> aim;   // the way of each node without elements [m]; src/method/holds/node_holds.wgsl
  gpu::Buffer<Vec4f> way;   // every second cycle's
  gpu::Buffer<Vec4f> left;  // of the global system [m]
  std::array<gpu::Buffer<Vec4f>, 2> change;  // of the way, in turns [m]

  /// Errors  Limit, OutOfMemory.
  static Result<RelaxedState> create(const SolverInputs& inputs, const Relaxation& relaxation);
  /// The ways after so many cycles. The last are in position[1 - parity], where a substep ends.
  const gpu::Buffer<Vec4f>& ways_after(std::size_t cycle, const State& state, std::size_t parity) const {
    return (relaxation.cycles.size() - cycle) % 2 == 0 ? state.position[1 - parity] : way;
  }
};

/// Errors  Shader, Limit, OutOfMemory.
template <class Bindings>
Result<gpu::Dispatch> dispatch_over(const SolverInputs& inputs, const char* shader, const Body& body,
                                    const Bindings& bindings,
                                    const std::vector<gpu::Constant>& constants = {}) {
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, shader, constants, inputs.workgroup_size));
  return gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(body.vertex_count), bindings);
}

/// What relaxes a cloth: its shader, its nodes, and the lists that the shader reads of it.
struct ClothRelaxation {
  const char* shader;
  gpu::Binding nodes;
  gpu::Dispatch::Bindings lists;
};
/// A further iteration of a cycle. Errors  Shader, Limit, OutOfMemory.
Result<gpu::Dispatch> relax_dispatch(const SolverInputs& inputs, const Body& body,
                                     const RelaxedState& relaxed, const ClothRelaxation& cloth,
                                     std::size_t cycle, std::size_t iteration);

/// The dispatches of a cloth's cycles: for each what `begin` gives for it, then its other iterations.
/// Errors  theirs.
template <class Begin>
Result<std::vector<gpu::Dispatch>> dispatches_of_cycles(const SolverInputs& inputs, const Body& body,
                                                        const RelaxedState& relaxed, const Begin& begin,
                                                        const ClothRelaxation& cloth) {
  std::vector<gpu::Dispatch> dispatches;
  for (std::size_t cycle = 0; cycle < relaxed.weights.size(); ++cycle) {
    WEFT_CHECK(begin(cycle, dispatches));
    for (std::size_t iteration = 0; iteration < relaxed.weights[cycle].size(); ++iteration) {
      WEFT_TRY(dispatch, relax_dispatch(inputs, body, relaxed, cloth, cycle, iteration));
      dispatches.push_back(std::move(dispatch));
    }
  }
  return dispatches;
}

}  // namespace weft
