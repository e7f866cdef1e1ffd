#include "contact/proximity/contact_counts.hpp"

namespace weft::contact {

Result<ContactCounts> ContactCounts::create(gpu::Device& device, const ContactPairs& pairs,
                                            const gpu::Buffer<float>& counts) {
  ContactCounts made;
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/proximity/count_contacts.wgsl"));
  made.kernel_ = std::move(kernel);
  WEFT_TRY(group, made.kernel_.bind({pairs.contacts, pairs.vertex_contacts, counts}));
  made.group_ = std::move(group);
  made.vertex_count_ = counts.size();
  return made;
}

}  // namespace weft::contact
