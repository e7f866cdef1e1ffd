#include "state/contact_pairs.hpp"

namespace weft {

Result<ContactPairs> ContactPairs::create(gpu::Device& device, const HostModel& model,
                                          const ContactRoom& room, bool presses) {
  const std::size_t vertices = model.vertex_count();
  ContactPairs made;
  made.room = room;
  WEFT_TRY(predicted, gpu::Buffer<Vec4f>::create(device, 2 * vertices, "predicted velocity"));
  made.predicted = std::move(predicted);
  WEFT_TRY(contacts, gpu::Buffer<Contact>::create(device, room.pairs, "contact pairs"));
  made.contacts = std::move(contacts);
  WEFT_TRY(entries, gpu::Buffer<std::uint32_t>::create(device, 4UL * room.pairs, "contact entries"));
  made.entries = std::move(entries);
  WEFT_TRY(words, gpu::Buffer<std::uint32_t>::create(device, kVertexWords * vertices, "vertex contacts"));
  made.vertex_contacts = std::move(words);
  if (presses) {
    WEFT_TRY(sums, gpu::Buffer<std::int32_t>::create(device, kPressWords * vertices, "presses"));
    made.presses = std::move(sums);
  }
  return made;
}

}  // namespace weft
