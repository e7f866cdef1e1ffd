#include "state/grab_slots.hpp"

#include <algorithm>

namespace weft {

void GrabSlots::set(gpu::Device& device, const GpuModel& model, std::span<const std::uint32_t> nodes,
                    std::size_t still) {
  still_ = still;
  if (std::equal(nodes.begin(), nodes.end(), nodes_.begin(), nodes_.end())) return;
  const auto mark = [&](std::uint32_t node, double word) {
    const Vec4f rest = Vec4f::from(model.host.rest_position[node].to<float>(), static_cast<float>(word));
    model.rest_position.write(device, std::span(&rest, 1), node);
  };
  for (const std::uint32_t node : nodes_) mark(node, model.host.motion[node]);
  nodes_.assign(nodes.begin(), nodes.end());
  for (std::size_t slot = nodes_.size(); slot-- > 0;) mark(nodes_[slot], -1.0 - static_cast<double>(slot));
  first_ = count_ = 0;
  if (nodes_.empty()) return;
  const auto [low, high] = std::minmax_element(nodes_.begin(), nodes_.end());
  first_ = *low;
  count_ = *high - *low + 1;
}

void GrabSlots::fill(StepBlock::Hands& hands, const State& state, std::uint32_t substep) const {
  const auto still = static_cast<std::uint32_t>(still_);
  hands.first = first_;
  hands.count = count_;
  hands.still = still;
  hands.first_still = state.first_goal;
  hands.first_moving = state.first_goal + state.still_goals - still +
                       substep * static_cast<std::uint32_t>(nodes_.size() - still_);
}

void GrabSlots::write_goals(gpu::Device& device, const State& state, std::span<const Vec4f> still,
                            std::span<const Vec4f> moving) {
  state.motions.write(device, still, state.first_goal);
  state.motions.write(device, moving, state.first_goal + state.still_goals);
}

}  // namespace weft
