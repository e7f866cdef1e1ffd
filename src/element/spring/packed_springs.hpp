#pragma once

#include <cstdint>
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

/// In an order that suits atomics. Errors  Limit: more than 2^24 nodes, or more than 256 kinds.
Result<PackedSprings> pack_springs(const std::vector<Spring>& springs, std::uint32_t vertex_count);

}  // namespace weft
