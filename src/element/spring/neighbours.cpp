#include "element/spring/neighbours.hpp"

#include <algorithm>
#include <cassert>

namespace weft {
namespace {

/// Where each slice begins: its nodes have as many entries each as the one with the most springs.
std::vector<std::uint64_t> slice_starts(const std::vector<std::uint32_t>& degrees) {
  std::vector<std::uint64_t> starts = {0};
  for (std::size_t first = 0; first < degrees.size(); first += kSlice) {
    const std::size_t end = std::min<std::size_t>(first + kSlice, degrees.size());
    const std::uint32_t most = *std::max_element(&degrees[first], &degrees[first] + (end - first));
    starts.push_back(starts.back() + static_cast<std::uint64_t>(most) * kSlice);
  }
  return starts;
}

}  // namespace

Result<Neighbours> build_neighbours(const std::vector<Spring>& springs, std::uint32_t first,
                                    std::uint32_t count) {
  if (static_cast<std::uint64_t>(first) + count > 1U << kNeighbourNodeBits)
    return make_error(ErrorKind::Limit, "Cloths of any shape number at most %u nodes in a scene, not %u.",
                      1U << kNeighbourNodeBits, first + count);
  std::vector<std::uint32_t> degrees(count, 0);
  for (const Spring& spring : springs) {
    ++degrees[spring.node_a - first];
    ++degrees[spring.node_b - first];
  }
  const std::vector<std::uint64_t> starts = slice_starts(degrees);
  if (starts.back() > 0xffffffffU)
    return make_error(ErrorKind::Limit, "The lists of the nodes' springs have %llu entries, more than %u.",
                      static_cast<unsigned long long>(starts.back()), 0xffffffffU);
  Neighbours built;
  built.slices.assign(starts.begin(), starts.end());
  SpringKinds kinds;
  const std::uint32_t nothing = kinds.number_of(SpringKind{});
  built.entries.resize(static_cast<std::size_t>(starts.back()));
  for (std::uint32_t slice = 0; slice + 1 < built.slices.size(); ++slice)
    for (std::uint32_t entry = built.slices[slice]; entry < built.slices[slice + 1]; ++entry)
      built.entries[entry].node_and_kind =
          (first + std::min(slice * kSlice + entry % kSlice, count - 1)) | (nothing << kNeighbourNodeBits);
  std::vector<std::uint32_t> next(count);
  for (std::uint32_t i = 0; i < count; ++i) next[i] = built.slices[i / kSlice] + i % kSlice;
  const auto add = [&](std::uint32_t node, std::uint32_t other, const Spring& spring) {
    std::uint32_t& entry = next[node - first];
    built.entries[entry] = {other | (kinds.number_of(spring) << kNeighbourNodeBits), spring.rest_length};
    entry += kSlice;
  };
  for (const Spring& spring : springs) {
    add(spring.node_a, spring.node_b, spring);
    add(spring.node_b, spring.node_a, spring);
  }
  built.kinds = kinds.all();
  assert(built.kinds.size() <= kNeighbourKinds);
  return built;
}

}  // namespace weft
