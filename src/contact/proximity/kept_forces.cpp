#include "contact/proximity/kept_forces.hpp"

namespace weft::contact {

Result<KeptForces> KeptForces::create(gpu::Device& device, bool twice, std::uint32_t workgroup_size) {
  KeptForces made;
  made.first_search_ = twice ? 0 : 1;
  const auto make = [&](Bound& bound, const char* name, std::vector<gpu::Constant> constants,
                        std::uint32_t size) -> Result<void> {
    const std::string path = std::string("contact/proximity/") + name + ".wgsl";
    WEFT_SET(bound.kernel, gpu::Kernel::create(device, path, std::move(constants), size));
    return {};
  };
  const auto make_keeping = [&](Keeping& keeping,
                                const std::vector<gpu::Constant>& constants) -> Result<void> {
    WEFT_CHECK(make(keeping.begin, "begin_keeping", constants, 1));
    return make(keeping.keep, "keep_forces", constants, workgroup_size);
  };
  WEFT_CHECK(make_keeping(made.of_frame_, {{"kList", 0}}));
  for (std::size_t starts = made.first_search_; starts < 2; ++starts) {
    const gpu::Constant constant{"kStarts", static_cast<double>(starts)};
    WEFT_CHECK(make_keeping(made.of_search_[starts], {{"kList", 1}, constant}));
    WEFT_CHECK(make(made.place_[starts], "place_kept_forces", {constant}, workgroup_size));
  }
  WEFT_CHECK(make(made.clear_, "clear_kept_places", {}, workgroup_size));
  return made;
}

Result<void> KeptForces::bind(const State& state, const ContactPairs& pairs) {
  const auto bind_keeping = [&](Keeping& keeping) -> Result<void> {
    WEFT_SET(keeping.begin.group, keeping.begin.kernel.bind({state.steps, state.statistics, pairs.kept}));
    WEFT_SET(keeping.keep.group,
             keeping.keep.kernel.bind({state.steps, pairs.contacts, state.statistics, pairs.kept}));
    return {};
  };
  WEFT_CHECK(bind_keeping(of_frame_));
  for (std::size_t starts = first_search_; starts < 2; ++starts) {
    WEFT_CHECK(bind_keeping(of_search_[starts]));
    WEFT_SET(place_[starts].group, place_[starts].kernel.bind({state.steps, state.statistics, pairs.kept}));
  }
  WEFT_SET(clear_.group, clear_.kernel.bind({state.statistics, pairs.kept}));
  near_room_ = pairs.room.near;
  return {};
}

void KeptForces::record_keep(gpu::ComputePass& pass, const Keeping& list) const {
  list.begin.kernel.dispatch_groups(pass, list.begin.group, {1});
  list.keep.kernel.dispatch_strided(pass, list.keep.group, near_room_);
}

void KeptForces::record_search(gpu::ComputePass& pass, bool starts) const {
  const std::size_t which = starts ? 1 : 0;
  record_keep(pass, of_search_[which]);
  clear_.kernel.dispatch_strided(pass, clear_.group, 2 * near_room_);
  place_[which].kernel.dispatch_strided(pass, place_[which].group, near_room_);
}

void KeptForces::record_frame_end(gpu::ComputePass& pass) const { record_keep(pass, of_frame_); }

}  // namespace weft::contact
