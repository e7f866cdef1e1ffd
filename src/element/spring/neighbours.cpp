#include "element/spring/neighbours.hpp"

#include <algorithm>
#include <cassert>

namespace weft {
Result<std::vector<std::uint32_t>> slice_starts(const mesh::Adjacency& rows) {
  std::vector<std::uint32_t> starts = {0};
  std::uint64_t next = 0;
  for (std::size_t first = 0; first < rows.row_count(); first += kSlice) {
    const std::size_t end = std::min<std::size_t>(first + kSlice, rows.row_count());
    std::size_t most = 0;
    for (std::size_t node = first; node < end; ++node) most = std::max(most, rows.row(node).size());
    next += static_cast<std::uint64_t>(most) * kSlice;
    starts.push_back(static_cast<std::uint32_t>(next));
  }
  if (next > 0xffffffffU)
    return make_error(ErrorKind::Limit, "The lists of the nodes' springs have %llu entries, more than %u.",
                      static_cast<unsigned long long>(next), 0xffffffffU);
  return starts;
}

Result<Neighbours> build_neighbours(const Springs& springs, const mesh::Adjacency& incidence,
                                    std::uint32_t first) {
  const auto count = static_cast<std::uint32_t>(incidence.row_count());
  if (static_cast<std::uint64_t>(first) + count > 1U << kNeighbourNodeBits)
    return make_error(ErrorKind::Limit, "Cloths of any shape number at most %u nodes in a scene, not %u.",
                      1U << kNeighbourNodeBits, first + count);
  Neighbours built;
  WEFT_SET(built.slices, slice_starts(incidence));
  SpringKinds kinds;
  const std::uint32_t nothing = kinds.number_of(SpringKind{});
  built.entries.resize(built.slices.back());
  for (std::uint32_t slice = 0; slice + 1 < built.slices.size(); ++slice)
    for (std::uint32_t entry = built.slices[slice]; entry < built.slices[slice + 1]; ++entry)
      built.entries[entry].node_and_kind =
          (first + std::min(slice * kSlice + entry % kSlice, count - 1)) | (nothing << kNeighbourNodeBits);
  std::vector<std::uint32_t> kind_of(springs.size());
  for (std::size_t s = 0; s < springs.size(); ++s) kind_of[s] = kinds.number_of(springs[s]);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t entry = built.slices[i / kSlice] + i % kSlice;
    for (const std::uint32_t s : incidence.row(i)) {
      const Spring spring = springs[s];
      const std::uint32_t other = spring.node_a == first + i ? spring.node_b : spring.node_a;
      built.entries[entry] = {other | (kind_of[s] << kNeighbourNodeBits), spring.rest_length};
      entry += kSlice;
    }
  }
  built.kinds = kinds.all();
  assert(built.kinds.size() <= kNeighbourKinds);
  return built;
}

}  // namespace weft
