#include "contact/pushes/push_scale.hpp"

#include <algorithm>
#include <cmath>

namespace weft::contact {

std::uint64_t triangles_at_vertex(const Model& model) {
  std::vector<std::uint64_t> counts(model.vertex_count(), 0);
  for (const mesh::Triangle& triangle : model.triangles)
    for (const std::uint32_t vertex : triangle) ++counts[vertex];
  return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

float push_scale(const PushBound& bound, double max_push) {
  const double pushes = static_cast<double>(bound.triangles_at_vertex) *
                            static_cast<double>(bound.object_triangles + bound.convex_bodies) +
                        static_cast<double>(bound.analytic_colliders);
  if (pushes == 0 || max_push <= 0) return 1;
  constexpr double kLimit = 2147483648.0;  // 2^31
  constexpr double kRounding = 1 + 1.0 / (1U << 21U);
  const auto fits = [&](int exponent) {
    return pushes * (max_push * kRounding * std::ldexp(1.0, exponent) + 1) < kLimit;
  };
  int exponent = 126;
  while (exponent > -126 && !fits(exponent)) --exponent;
  return std::ldexp(1.0F, exponent);
}

}  // namespace weft::contact
