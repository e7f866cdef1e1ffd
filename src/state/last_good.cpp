#include "state/last_good.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

bool is_finite(const Vec4f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

Result<LastGood> LastGood::create(gpu::Device& device, const State& state, bool with_step_before,
                                  const gpu::Buffer<std::int32_t>* presses,
                                  const gpu::Buffer<std::uint32_t>* rigid) {
  LastGood made;
  WEFT_TRY(guard, gpu::Kernel::create(device, "state/guard.wgsl"));
  made.guard_ = std::move(guard);
  WEFT_TRY(keep, gpu::Kernel::create(device, "state/keep_last_good.wgsl"));
  made.keep_ = std::move(keep);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.guard_.bind({state.position[parity], state.velocity[parity], state.statistics}));
    made.guard_groups_[parity] = std::move(group);
  }
  for (std::size_t age = 0; age < (with_step_before ? 2 : 1); ++age) {
    Kept kept;
    WEFT_TRY(position, gpu::Buffer<Vec4f>::create(device, state.position[0].size(), "last good position"));
    kept.position = std::move(position);
    WEFT_TRY(velocity, gpu::Buffer<Vec4f>::create(device, state.velocity[0].size(), "last good velocity"));
    kept.velocity = std::move(velocity);
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const std::size_t at = (parity + age) & 1U;
      WEFT_TRY(group, made.keep_.bind({state.position[at], state.velocity[at], kept.position, kept.velocity,
                                       state.statistics}));
      kept.groups[parity] = std::move(group);
    }
    made.kept_.push_back(std::move(kept));
  }
  if (presses != nullptr || rigid != nullptr || state.creases.size() > 0)
    WEFT_SET(made.keep_holds_, gpu::Kernel::create(device, "state/keep_last_holds.wgsl"));
  if (rigid != nullptr) {
    made.rigid_ = rigid;
    WEFT_SET(made.good_rigid_,
             gpu::Buffer<std::uint32_t>::create(device, rigid->size(), "last good rigid bodies"));
    WEFT_SET(made.keep_rigid_group_, made.keep_holds_.bind({*rigid, made.good_rigid_, state.statistics}));
  }
  if (state.creases.size() > 0) {
    WEFT_SET(made.creases_, gpu::Buffer<Vec4f>::create(device, state.creases.size(), "last good creases"));
    WEFT_SET(made.keep_creases_group_,
             made.keep_holds_.bind({state.creases, made.creases_, state.statistics}));
  }
  if (presses == nullptr) return made;
  made.presses_ = presses;
  const std::size_t words = kHoldWords * state.position[0].size();
  WEFT_SET(made.holds_, gpu::Buffer<std::int32_t>::create(device, words, "last good holds"));
  WEFT_SET(made.keep_holds_group_, made.keep_holds_.bind({*presses, made.holds_, state.statistics}));
  return made;
}

void LastGood::record(gpu::ComputePass& pass) const {
  guard_.dispatch(pass, guard_groups_[pass.parity()], kept_[0].position.size());
  for (const Kept& kept : kept_) keep_.dispatch(pass, kept.groups[pass.parity()], kept.position.size());
  if (presses_ != nullptr) keep_holds_.dispatch(pass, keep_holds_group_, holds_.size());
  if (rigid_ != nullptr) keep_holds_.dispatch(pass, keep_rigid_group_, good_rigid_.size());
  if (creases_.size() > 0) keep_holds_.dispatch(pass, keep_creases_group_, 4 * creases_.size());
}

void LastGood::record_restore(gpu::CommandList& list, const State& state, std::uint32_t parity) const {
  for (std::size_t age = 0; age < kept_.size(); ++age) {
    const std::size_t at = (parity + age) & 1U;
    list.copy(kept_[age].position.source(), state.position[at].source());
    list.copy(kept_[age].velocity.source(), state.velocity[at].source());
  }
  if (presses_ != nullptr) list.copy(holds_.source(), presses_->range(0, holds_.bytes()));
  if (rigid_ != nullptr) list.copy(good_rigid_.source(), rigid_->source());
  if (creases_.size() > 0) list.copy(creases_.source(), state.creases.source());
}

void LastGood::renew(gpu::Device& device, std::span<const Vec4f> position, std::span<const Vec4f> velocity,
                     std::size_t first) const {
  if (!std::all_of(position.begin(), position.end(), is_finite) ||
      !std::all_of(velocity.begin(), velocity.end(), is_finite))
    return;
  kept_[0].position.write(device, position, first);
  kept_[0].velocity.write(device, velocity, first);
}

void LastGood::renew_before(gpu::Device& device, std::span<const Vec4f> position,
                            std::span<const Vec4f> velocity) const {
  kept_[1].position.write(device, position);
  kept_[1].velocity.write(device, velocity);
}

void LastGood::renew_creases(gpu::Device& device, std::span<const Vec4f> creases) const {
  creases_.write(device, creases);
}

void LastGood::record_rigid(gpu::CommandList& list) const {
  if (rigid_ != nullptr) list.copy(rigid_->source(), good_rigid_.source());
}

void LastGood::renew_holds(gpu::Device& device, std::span<const std::int32_t> forces) const {
  if (presses_ != nullptr) holds_.write(device, forces);
}

}  // namespace weft
