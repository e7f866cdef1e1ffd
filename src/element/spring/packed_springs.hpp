#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "element/spring/spring_kinds.hpp"

namespace weft {

/// A spring in 12 bytes instead of the 20 of Spring. Mirror: Spring in src/element/spring/packed_spring.wgsl.
struct PackedSpring {
  std::uint32_t node_a = 0, node_b_and_kind = 0;
  float rest_length = 0;  // [m]
};
static_assert(sizeof(PackedSpring) == 12);
inline constexpr std::uint32_t kSpringNodeBits = 24;

struct PackedSprings {
  std::vector<PackedSpring> springs;
  std::vector<SpringKind> kinds;
};

/// An order that suits atomics: as they come, spread within windows.
std::vector<std::uint32_t> atomic_order(const Springs& springs);

/// The springs in this order. Errors  Limit: more than 2^24 nodes, or more than 256 kinds.
Result<PackedSprings> pack_springs(const Springs& springs, std::span<const std::uint32_t> order,
                                   std::uint32_t vertex_count);

}  // namespace weft
