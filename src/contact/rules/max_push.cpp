#include "contact/rules/max_push.hpp"

#include <algorithm>

namespace weft {

double max_push(const Model& model, double thickness) {
  double longest = 0;
  for (const Body& body : model.bodies)
    for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
      const auto [a, b, c] = rest_corners(model, body, t);
      longest = std::max({longest, length(b - a), length(c - b), length(a - c)});
    }
  return thickness + 2 * longest;
}

}  // namespace weft
