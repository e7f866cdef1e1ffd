#pragma once

#include <span>
#include <vector>

#include "state/state.hpp"

namespace weft {

/// The grabbed nodes as kernels find them (grab.wgsl). Each has a slot, which rest[node].w names as -(1 + slot), and a
/// goal in `motions`: one for all substeps of a frame where it stands still, else one for each substep.
class GrabSlots {
 public:
  /// Gives slots to these nodes, from the next submit on, and takes those of all others; of a node that comes twice the
  /// first counts. The goals of the first `still` stand still. Writes where something changes only.
  void set(gpu::Device& device, const GpuModel& model, std::span<const std::uint32_t> nodes,
           std::size_t still);
  /// Fills a substep's part, but for rate and speed.
  void fill(StepBlock::Hands& hands, const State& state, std::uint32_t substep) const;
  /// Writes where nodes are pulled [m], w: 1, or 0 where nothing pulls them. `still`: one goal a slot; `moving`: one
  /// for each other slot, substep after substep.
  static void write_goals(gpu::Device& device, const State& state, std::span<const Vec4f> still,
                          std::span<const Vec4f> moving);

 private:
  std::vector<std::uint32_t> nodes_;
  std::size_t still_ = 0;
  std::uint32_t first_ = 0, count_ = 0;  // of the nodes that include these
};

}  // namespace weft
