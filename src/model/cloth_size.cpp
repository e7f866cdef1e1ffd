#include "model/cloth_size.hpp"

#include <numeric>

namespace weft {

double mass_of(const Model& model, const Body& body) {
  const auto first = model.mass.begin() + body.first_vertex;
  return std::accumulate(first, first + body.vertex_count, 0.0);
}

namespace {

double twice_area(const Model& model, const mesh::Triangle& triangle) {
  const Vec3d& a = model.rest_position[triangle[0]];
  return length(cross(model.rest_position[triangle[1]] - a, model.rest_position[triangle[2]] - a));
}

}  // namespace

double area_of(const Model& model, const mesh::Triangle& triangle) { return twice_area(model, triangle) / 2; }

double area_of(const Model& model, const Body& body) {
  double twice = 0;
  for (std::uint32_t t = body.first_triangle; t < body.first_triangle + body.triangle_count; ++t)
    twice += twice_area(model, model.triangles[t]);
  return twice / 2;
}

}  // namespace weft
