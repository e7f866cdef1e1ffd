#include "contact/rules/max_push.hpp"

#include <algorithm>

namespace weft {

double max_push(const Model& model, double thickness) {
  double longest = 0;
  const auto take = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    longest = std::max({longest, length(b - a), length(c - b), length(a - c)});
  };
  for (const auto& [a, b, c] : model.triangles)
    take(model.rest_position[a], model.rest_position[b], model.rest_position[c]);
  for (const Body& body : model.bodies)
    for (std::uint32_t t = 0; body.pattern && t < body.triangle_count; ++t) {
      const auto [a, b, c] = rest_corners(model, body, t);
      take(a, b, c);
    }
  return thickness + 2 * longest;
}

}  // namespace weft
