#include "model/cloth_size.hpp"

#include <numeric>

#include "model/solid.hpp"

namespace weft {

double mass_of(const Model& model, const Body& body) {
  const auto first = model.mass.begin() + body.first_vertex;
  return std::accumulate(first, first + body.vertex_count, 0.0);
}

namespace {

double twice_area(const std::array<Vec3d, 3>& corners) {
  return length(cross(corners[1] - corners[0], corners[2] - corners[0]));
}

}  // namespace

double area_of(const Model& model, const mesh::Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return twice_area({model.rest_position[a], model.rest_position[b], model.rest_position[c]}) / 2;
}

double area_of(const Model& model, const Body& body) {
  double twice = 0;
  for (std::uint32_t t = 0; t < body.triangle_count; ++t) twice += twice_area(rest_corners(model, body, t));
  return twice / 2;
}

double volume_of(const Model& model, const Body& body) {
  double sum = 0;
  for (const tet::Rest& rest : body_tets(model, body).rests) sum += rest.volume;
  return sum;
}

}  // namespace weft
