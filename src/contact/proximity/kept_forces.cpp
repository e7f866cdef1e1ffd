#include "contact/proximity/kept_forces.hpp"

namespace weft::contact {

Result<KeptForces> KeptForces::create(gpu::Device& device, std::uint32_t workgroup_size) {
  KeptForces made;
  for (std::size_t list = 0; list < 2; ++list) {
    const std::vector<gpu::Constant> constants = {{"kList", static_cast<double>(list)}};
    WEFT_TRY(begin, gpu::Kernel::create(device, "contact/proximity/begin_keeping.wgsl", constants, 1));
    made.begin_[list] = std::move(begin);
    WEFT_TRY(keep,
             gpu::Kernel::create(device, "contact/proximity/keep_forces.wgsl", constants, workgroup_size));
    made.keep_[list] = std::move(keep);
  }
  WEFT_TRY(clear,
           gpu::Kernel::create(device, "contact/proximity/clear_kept_places.wgsl", {}, workgroup_size));
  made.clear_ = std::move(clear);
  WEFT_TRY(place,
           gpu::Kernel::create(device, "contact/proximity/place_kept_forces.wgsl", {}, workgroup_size));
  made.place_ = std::move(place);
  return made;
}

Result<void> KeptForces::bind(const State& state, const ContactPairs& pairs) {
  for (std::size_t list = 0; list < 2; ++list) {
    WEFT_TRY(begin, begin_[list].bind({state.steps, state.statistics, pairs.kept}));
    begin_groups_[list] = std::move(begin);
    WEFT_TRY(keep, keep_[list].bind({state.steps, pairs.contacts, state.statistics, pairs.kept}));
    keep_groups_[list] = std::move(keep);
  }
  WEFT_TRY(clear, clear_.bind({state.statistics, pairs.kept}));
  clear_group_ = std::move(clear);
  WEFT_TRY(place, place_.bind({state.steps, state.statistics, pairs.kept}));
  place_group_ = std::move(place);
  near_room_ = pairs.room.near;
  return {};
}

void KeptForces::record_keep(gpu::ComputePass& pass, std::size_t list) const {
  begin_[list].dispatch_groups(pass, begin_groups_[list], {1});
  keep_[list].dispatch_strided(pass, keep_groups_[list], near_room_);
}

void KeptForces::record_search(gpu::ComputePass& pass) const {
  record_keep(pass, 1);
  clear_.dispatch_strided(pass, clear_group_, 2 * near_room_);
  place_.dispatch_strided(pass, place_group_, near_room_);
}

void KeptForces::record_frame_end(gpu::ComputePass& pass) const { record_keep(pass, 0); }

}  // namespace weft::contact
