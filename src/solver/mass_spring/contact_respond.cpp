#include "solver/mass_spring/contact_respond.hpp"

namespace weft {

Result<ContactRespond> ContactRespond::create(gpu::Device& device, const State& state,
                                              const ContactPairs& pairs, std::uint32_t workgroup_size) {
  ContactRespond made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "mass_spring/contact_respond.wgsl", {}, workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, state.position[parity], pairs.predicted, pairs.contacts,
                                       pairs.entries, pairs.vertex_contacts, state.position[1 - parity],
                                       state.velocity[1 - parity], state.statistics}));
    made.groups_[parity] = std::move(group);
  }
  made.count_ = state.position[0].size();
  return made;
}

}  // namespace weft
