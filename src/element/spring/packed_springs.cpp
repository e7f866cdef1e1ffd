#include "element/spring/packed_springs.hpp"

#include <algorithm>

#include "element/spring/spread_order.hpp"

namespace weft {
namespace {

constexpr std::size_t kWindow =
    4096;  // springs: near each other on the sheet, and more than a workgroup takes

}  // namespace

std::vector<std::uint32_t> atomic_order(const Springs& springs) {
  std::vector<std::uint32_t> order;
  order.reserve(springs.size());
  std::vector<std::uint32_t> nodes;
  for (std::size_t first = 0; first < springs.size(); first += kWindow) {
    nodes.clear();
    for (std::size_t i = first; i < std::min(first + kWindow, springs.size()); ++i)
      nodes.push_back(springs[i].node_a);
    for (const std::uint32_t k : spread_order(nodes)) order.push_back(static_cast<std::uint32_t>(first) + k);
  }
  return order;
}

Result<PackedSprings> pack_springs(const Springs& springs, std::span<const std::uint32_t> order,
                                   std::uint32_t vertex_count) {
  constexpr std::uint32_t kMostNodes = 1U << kSpringNodeBits;
  constexpr std::size_t kMostKinds = 1U << (32 - kSpringNodeBits);
  if (vertex_count > kMostNodes)
    return make_error(ErrorKind::Limit, "Packed springs number at most %u nodes, not %u.", kMostNodes,
                      vertex_count);
  PackedSprings packed;
  packed.springs.reserve(springs.size());
  SpringKinds kinds;
  for (const std::uint32_t index : order) {
    const Spring spring = springs[index];
    const std::uint32_t kind = kinds.number_of(spring);
    packed.springs.push_back({spring.node_a, spring.node_b | (kind << kSpringNodeBits), spring.rest_length});
    if (kinds.all().size() > kMostKinds)
      return make_error(ErrorKind::Limit,
                        "Packed springs have at most %zu pairs of stiffness and damping in a scene.",
                        kMostKinds);
  }
  packed.kinds = kinds.all();
  return packed;
}

}  // namespace weft
