#pragma once

#include <cstdint>

#include "element/spring/spring.hpp"

namespace weft {

/// How forces are turned into integers for Algorithm 1's atomic sums.
struct ForceFixedPoint {
  float limit = 0;  // the largest tension of a spring that is passed on [N]
  float scale = 1;  // units per newton, a power of two
};

/// The largest power of two for which no node's sum can overflow 31 bits, whatever the state.
///
/// A spring's tension is cut to `limit` = the largest k · rest_length of all springs: that of a spring
/// stretched to twice its length. A node with v springs then sums v terms of at most round(scale · limit) ≤
/// scale · limit + 1/2 per axis, and scale · limit · v + v / 2 < 2^31 holds for scale < (2^31 - v / 2) /
/// (limit · v). A direction is a quotient of a span by its f32 length, each within 2.5 ulp: a component can
/// exceed 1, by less than the 2^-20 that is left for it.
ForceFixedPoint force_fixed_point(const Springs& springs, std::uint32_t vertex_count);

}  // namespace weft
