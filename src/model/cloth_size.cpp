#include "model/cloth_size.hpp"

#include <numeric>

namespace weft {

double mass_of(const Model& model, const Body& body) {
  const auto first = model.mass.begin() + body.first_vertex;
  return std::accumulate(first, first + body.vertex_count, 0.0);
}

double area_of(const Model& model, const Body& body) {
  double twice = 0;
  for (std::uint32_t t = body.first_triangle; t < body.first_triangle + body.triangle_count; ++t) {
    const auto& [a, b, c] = model.triangles[t];
    const auto& x = model.rest_position;
    twice += length(cross(x[b] - x[a], x[c] - x[a]));
  }
  return twice / 2;
}

}  // namespace weft
