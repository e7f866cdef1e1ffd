#pragma once

#include <array>
#include <optional>

#include "gpu/buffer.hpp"
#include "state/contact_pairs.hpp"
#include "state/gpu_model.hpp"
#include "state/statistics.hpp"
#include "state/step_block.hpp"

namespace weft {

/// The varying state. Position and velocity have two buffers each: a substep with parity p reads [p], which
/// thereby is the previous state, and writes [1 - p].
struct State {
  std::array<gpu::Buffer<Vec4f>, 2> position;  // vertex_count, m; w: inverse mass, 1/kg (0: kinematic)
  std::array<gpu::Buffer<Vec4f>, 2>
      velocity;  // vertex_count, m/s; w: 1 where the state before it is known (Method::history)
  gpu::Buffer<StepBlock> steps;  // a block for each substep of a frame
  /// 3 rows for each moved group and substep: x, y, z of R·rest + t. Behind them, from `first_goal` on, where grabbed
  /// nodes are pulled (GrabSlots): room for `still_goals`, then for the goals of each substep.
  gpu::Buffer<Vec4f> motions;
  std::uint32_t first_goal = 0, still_goals = 0;
  gpu::Buffer<std::uint32_t> statistics;  // sizeof(Statistics) / 4
  /// What each facet of cloth that keeps bends keeps at its three edges, rad, and in w all curvature that it has kept,
  /// 1/m: cloth after cloth (first_crease of model/fabric.hpp). Changed as a substep begins.
  gpu::Buffer<Vec4f> creases;  // crease_count(model)

  /// The start, at rest. `moving_goals`: of the scene's own grabs that act in a frame, at most.
  /// Errors  Limit, OutOfMemory.
  static Result<State> create(gpu::Device& device, const Model& model, std::uint32_t substeps,
                              std::size_t moving_goals = 0);
  /// Writes the start, at rest, into both buffers.
  void reset(gpu::Device& device, const Model& model) const;
};

/// The contacts for a solver: either of the two.
struct Contacts {
  /// Of methods paper and bvh: for each vertex the sum of its pushes and their number, in fixed point
  /// (push_scale of StepBlock::Contact), so that neither depends on the order of threads.
  gpu::Buffer<std::int32_t> pushes;  // 4 * vertex_count: x, y, z, count; the solver clears them after reading
  /// Of method proximity: pairs of features, for the solver to answer.
  std::optional<ContactPairs> pairs;

  static Result<Contacts> create_pushes(gpu::Device& device, const Model& model);
  static Result<Contacts> create_pairs(gpu::Device& device, const Model& model, const ContactRoom& room,
                                       const SolvedContact& solved);
};

}  // namespace weft
