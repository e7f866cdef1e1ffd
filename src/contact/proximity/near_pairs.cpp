#include "contact/proximity/near_pairs.hpp"

namespace weft::contact {

Result<NearPairs> NearPairs::create(gpu::Device& device, bool presses, std::uint32_t workgroup_size) {
  NearPairs made;
  made.presses_ = presses;
  const char* path = "contact/proximity/find_near.wgsl";
  WEFT_SET(made.kernel_,
           gpu::Kernel::create(device, path, {{"kStarts", presses ? 0.0 : 1.0}}, workgroup_size));
  if (presses) WEFT_SET(made.early_, gpu::Kernel::create(device, path, {{"kEarly", 1}}, workgroup_size));
  return made;
}

Result<void> NearPairs::bind(const State& state, const ContactPairs& pairs,
                             const gpu::Buffer<Vec4f>& points) {
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto bind = [&](const gpu::Kernel& kernel, const gpu::Buffer<Vec4f>& velocity) {
      return kernel.bind({state.steps, state.position[parity], velocity, points, pairs.listed, pairs.contacts,
                          pairs.vertex_contacts, state.statistics, pairs.kept});
    };
    WEFT_SET(groups_[parity], bind(kernel_, pairs.predicted));
    if (!presses_) continue;
    WEFT_SET(early_groups_[parity], bind(early_, state.velocity[parity]));
    WEFT_SET(again_groups_[parity], bind(early_, pairs.predicted));
  }
  pair_room_ = pairs.room.pairs;
  return {};
}

void NearPairs::record(gpu::ComputePass& pass) const {
  kernel_.dispatch_strided(pass, groups_[pass.parity()], pair_room_);
}

void NearPairs::record_early(gpu::ComputePass& pass) const {
  early_.dispatch_strided(pass, early_groups_[pass.parity()], pair_room_);
}

void NearPairs::record_again(gpu::ComputePass& pass) const {
  early_.dispatch_strided(pass, again_groups_[pass.parity()], pair_room_);
}

}  // namespace weft::contact
