#include "element/last_good.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

bool is_finite(const Vec4f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

Result<LastGood> LastGood::create(gpu::Device& device, const State& state) {
  LastGood made;
  WEFT_TRY(guard, gpu::Kernel::create(device, "element/guard.wgsl"));
  made.guard_ = std::move(guard);
  WEFT_TRY(keep, gpu::Kernel::create(device, "element/keep_last_good.wgsl"));
  made.keep_ = std::move(keep);
  WEFT_TRY(position, gpu::Buffer<Vec4f>::create(device, state.position[0].size(), "last good position"));
  made.position_ = std::move(position);
  WEFT_TRY(velocity, gpu::Buffer<Vec4f>::create(device, state.velocity[0].size(), "last good velocity"));
  made.velocity_ = std::move(velocity);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(guard_group,
             made.guard_.bind({state.position[parity], state.velocity[parity], state.statistics}));
    made.guard_groups_[parity] = std::move(guard_group);
    WEFT_TRY(keep_group, made.keep_.bind({state.position[parity], state.velocity[parity], made.position_,
                                          made.velocity_, state.statistics}));
    made.keep_groups_[parity] = std::move(keep_group);
  }
  return made;
}

void LastGood::record(gpu::ComputePass& pass) const {
  guard_.dispatch(pass, guard_groups_[pass.parity()], position_.size());
  keep_.dispatch(pass, keep_groups_[pass.parity()], position_.size());
}

void LastGood::record_restore(gpu::CommandList& list, const State& state, std::uint32_t parity) const {
  list.copy(position_.source(), state.position[parity].source());
  list.copy(velocity_.source(), state.velocity[parity].source());
}

void LastGood::renew(gpu::Device& device, std::span<const Vec4f> position, std::span<const Vec4f> velocity,
                     std::size_t first) const {
  if (!std::all_of(position.begin(), position.end(), is_finite) ||
      !std::all_of(velocity.begin(), velocity.end(), is_finite))
    return;
  position_.write(device, position, first);
  velocity_.write(device, velocity, first);
}

}  // namespace weft
