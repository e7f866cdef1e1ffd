#include "contact/proximity/respond.hpp"

namespace weft::contact {

Result<Respond> Respond::create(gpu::Device& device, std::uint32_t interval, std::uint32_t workgroup_size) {
  Respond made;
  WEFT_TRY(impulse,
           gpu::Kernel::create(device, "contact/proximity/contact_impulse.wgsl", {}, workgroup_size));
  made.impulse_ = std::move(impulse);
  WEFT_TRY(respond,
           gpu::Kernel::create(device, "contact/proximity/contact_respond.wgsl",
                               {{"kDetectInterval", static_cast<double>(interval)}}, workgroup_size));
  made.respond_ = std::move(respond);
  return made;
}

Result<void> Respond::bind(const State& state, const ContactPairs& pairs) {
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

void Respond::record_impulses(gpu::ComputePass& pass) const {
  impulse_.dispatch_strided(pass, impulse_groups_[pass.parity()], pair_room_);
}

void Respond::record_hold_back(gpu::ComputePass& pass) const {
  respond_.dispatch(pass, respond_groups_[pass.parity()], vertex_count_);
}

}  // namespace weft::contact
