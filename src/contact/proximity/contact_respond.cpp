#include "contact/proximity/contact_respond.hpp"

namespace weft {

Result<ContactRespond> ContactRespond::create(gpu::Device& device, const State& state,
                                              const ContactPairs& pairs, std::uint32_t interval,
                                              std::uint32_t workgroup_size) {
  ContactRespond made;
  WEFT_TRY(impulse, gpu::Kernel::create(device, "contact/proximity/contact_impulse.wgsl", {}, workgroup_size));
  made.impulse_ = std::move(impulse);
  WEFT_TRY(respond,
           gpu::Kernel::create(device, "contact/proximity/contact_respond.wgsl",
                               {{"kDetectInterval", static_cast<double>(interval)}}, workgroup_size));
  made.respond_ = std::move(respond);
  WEFT_CHECK(made.bind(state, pairs));
  return made;
}

Result<void> ContactRespond::bind(const State& state, const ContactPairs& pairs) {
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(impulse_group, impulse_.bind({state.steps, state.position[parity], pairs.predicted,
                                           pairs.contacts, pairs.vertex_contacts, state.statistics}));
    impulse_groups_[parity] = std::move(impulse_group);
    WEFT_TRY(respond_group,
             respond_.bind({state.steps, state.position[parity], pairs.predicted, pairs.contacts,
                            pairs.entries, pairs.vertex_contacts, state.position[1 - parity],
                            state.velocity[1 - parity], state.statistics}));
    respond_groups_[parity] = std::move(respond_group);
  }
  pair_room_ = pairs.room.pairs;
  vertex_count_ = state.position[0].size();
  return {};
}

void ContactRespond::record(gpu::ComputePass& pass) const {
  impulse_.dispatch_strided(pass, impulse_groups_[pass.parity()], pair_room_);
  respond_.dispatch(pass, respond_groups_[pass.parity()], vertex_count_);
}

}  // namespace weft
