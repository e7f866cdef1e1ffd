#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/result.hpp"
#include "contact/object_tree.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Contacts through a tree over the object triangles: the pairs and pushes of PairsPaper, bit for bit.
/// Reads   state.steps; state.position [m]: predicted and previous; model.triangles.
/// Writes  contacts.pushes [m * push_scale; count], state.statistics: added to.
/// Errors  Limit: the tree needs a longer stack than the kernel has. Shader, OutOfMemory. Source:
/// docs/collision.md.
class PairsBvh {
 public:
  PairsBvh() = default;
  static Result<PairsBvh> create(gpu::Device& device, const GpuModel& model, const State& state,
                                 const Contacts& contacts, std::span<const ObjectTriangle> triangles,
                                 std::uint32_t workgroup_size, std::uint32_t triangles_each);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel kernel_;
  gpu::Buffer<TreeNode> nodes_;
  gpu::Buffer<ObjectTriangle> triangles_;
  gpu::Buffer<std::uint32_t> ids_;
  std::array<gpu::BindGroup, 2> groups_;  // by parity
  std::uint32_t invocations_ = 0;
};

}  // namespace weft::contact
