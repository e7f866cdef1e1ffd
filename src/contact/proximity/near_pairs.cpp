#include "contact/proximity/near_pairs.hpp"

namespace weft::contact {

Result<NearPairs> NearPairs::create(gpu::Device& device, std::uint32_t workgroup_size) {
  NearPairs made;
  WEFT_SET(made.kernel_, gpu::Kernel::create(device, "contact/proximity/find_near.wgsl", {}, workgroup_size));
  return made;
}

Result<void> NearPairs::bind(const State& state, const ContactPairs& pairs,
                             const gpu::Buffer<Vec4f>& points) {
  for (std::size_t parity = 0; parity < 2; ++parity)
    WEFT_SET(groups_[parity],
             kernel_.bind({state.steps, state.position[parity], pairs.predicted, points, pairs.listed,
                           pairs.contacts, pairs.vertex_contacts, state.statistics, pairs.kept}));
  pair_room_ = pairs.room.pairs;
  return {};
}

void NearPairs::record(gpu::ComputePass& pass) const {
  kernel_.dispatch_strided(pass, groups_[pass.parity()], pair_room_);
}

}  // namespace weft::contact
