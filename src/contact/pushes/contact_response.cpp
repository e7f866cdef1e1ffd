#include "contact/pushes/contact_response.hpp"

namespace weft {

Result<ContactResponse> ContactResponse::create(gpu::Device& device, const State& state,
                                                const Contacts& contacts, std::uint32_t workgroup_size) {
  ContactResponse made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/pushes/contact_response.wgsl", {}, workgroup_size));
  made.kernel_ = std::move(kernel);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.kernel_.bind({state.steps, state.position[parity], contacts.pushes,
                                       state.position[1 - parity], state.velocity[1 - parity]}));
    made.groups_[parity] = std::move(group);
  }
  made.count_ = state.position[0].size();
  return made;
}

}  // namespace weft
