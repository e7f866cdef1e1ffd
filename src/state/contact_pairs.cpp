#include "state/contact_pairs.hpp"

#include <algorithm>
#include <bit>

namespace weft {

ContactRoom grown(const ContactRoom& room, const ContactRoom& wanted, std::uint64_t most_bytes) {
  constexpr std::uint64_t kMost = 1U << 28U;
  const auto longer = [&](std::uint32_t has, std::uint32_t needs, std::uint64_t element_bytes) {
    if (needs <= has) return has;
    const std::uint64_t most = std::min(kMost, std::max<std::uint64_t>(most_bytes / element_bytes, needs));
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(needs + needs / 2ULL, most));
  };
  constexpr std::uint64_t kCandidateBytes = 8;
  return {longer(room.pairs, wanted.pairs, sizeof(ListedPair)),
          longer(room.near, wanted.near, sizeof(Contact)),
          longer(room.candidates, wanted.candidates, kCandidateBytes)};
}

Result<ContactPairs> ContactPairs::create(gpu::Device& device, const Model& model, const ContactRoom& room,
                                          const SolvedContact& solved) {
  const std::size_t vertices = model.vertex_count();
  ContactPairs made;
  WEFT_TRY(predicted, gpu::Buffer<Vec4f>::create(device, 3 * vertices, "predicted velocity"));
  made.predicted = std::move(predicted);
  if (solved.pairs)
    WEFT_SET(made.pair_sums,
             gpu::Buffer<std::uint32_t>::create(device, kPairSumWords * vertices, "sums over held pairs"));
  WEFT_CHECK(made.make_room(device, room));
  WEFT_TRY(words, gpu::Buffer<std::uint32_t>::create(device, kVertexWords * vertices, "vertex contacts"));
  made.vertex_contacts = std::move(words);
  if (solved.obstacles) {
    WEFT_TRY(sums,
             gpu::Buffer<std::int32_t>::create(device, (kHoldWords + kPressWords) * vertices, "presses"));
    made.presses = std::move(sums);
  }
  return made;
}

Result<void> ContactPairs::make_room(gpu::Device& device, const ContactRoom& wanted) {
  listed = {};  // freed before larger ones are allocated
  contacts = {};
  WEFT_TRY(listed_buffer, gpu::Buffer<ListedPair>::create(device, wanted.pairs, "contact pairs"));
  listed = std::move(listed_buffer);
  WEFT_TRY(contact_buffer, gpu::Buffer<Contact>::create(device, wanted.near, "near pairs"));
  contacts = std::move(contact_buffer);
  if (pair_sums.size() > 0) {
    pair_holds = {};
    WEFT_SET(pair_holds, gpu::Buffer<PairHold>::create(device, wanted.near, "held pairs"));
  }
  const std::uint64_t words = kHeader + 2ULL * kKeptWords * wanted.near + std::bit_ceil(2ULL * wanted.near);
  WEFT_TRY(kept_buffer, gpu::Buffer<std::uint32_t>::create(device, words, "kept forces"));
  if (kept.size() > 0) {  // the list of the frame's end, which comes first
    const std::uint64_t bytes = 4ULL * (kHeader + kKeptWords * std::min(room.near, wanted.near));
    gpu::CommandList list;
    list.copy(kept.range(0, bytes), kept_buffer.range(0, bytes));
    WEFT_CHECK(device.submit(list));
  }
  kept = std::move(kept_buffer);
  kept.write(device, std::span(&wanted.near, 1), kKeptRoomWord);
  room = wanted;
  return {};
}

}  // namespace weft
