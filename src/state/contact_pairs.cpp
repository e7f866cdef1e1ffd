#include "state/contact_pairs.hpp"

namespace weft {

Result<ContactPairs> ContactPairs::create(gpu::Device& device, const HostModel& model,
                                          std::uint32_t capacity) {
  const auto vertices = static_cast<std::uint32_t>(model.vertex_count());
  ContactPairs made;
  made.capacity = capacity;
  WEFT_TRY(predicted, gpu::Buffer<Vec4f>::create(device, 2UL * vertices, "predicted velocity"));
  made.predicted = std::move(predicted);
  WEFT_TRY(contacts, gpu::Buffer<Contact>::create(device, capacity, "contact pairs"));
  made.contacts = std::move(contacts);
  WEFT_TRY(entries, gpu::Buffer<std::uint32_t>::create(device, 4UL * capacity, "contact entries"));
  made.entries = std::move(entries);
  WEFT_TRY(words, gpu::Buffer<std::uint32_t>::create(
                      device, 1UL * kVertexWords * vertices + scan_blocks(vertices) + 1, "vertex contacts"));
  made.vertex_contacts = std::move(words);
  return made;
}

}  // namespace weft
