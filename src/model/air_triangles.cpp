#include "model/air_triangles.hpp"

namespace weft {
namespace {

/// Whether the edge between two nodes of a grid, which count from 0, is a diagonal.
bool is_diagonal(std::uint32_t a, std::uint32_t b, std::uint32_t row) {
  return a % row != b % row && a / row != b / row;
}

std::array<double, 3> shares_of(const mesh::Triangle& t, const Body& body) {
  if (!body.grid) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const auto share = [&](std::size_t corner) {
    const std::uint32_t a = t[(corner + 1) % 3], b = t[(corner + 2) % 3];
    return is_diagonal(a - body.first_vertex, b - body.first_vertex, body.grid->nx) ? 0.5 : 0.25;
  };
  return {share(0), share(1), share(2)};
}

}  // namespace

std::vector<AirTriangle> air_triangles(const Model& model) {
  std::vector<AirTriangle> made;
  made.reserve(model.triangles.size());
  for (const Body& body : model.bodies) {
    if (body.solid) continue;  // its triangles have one face, and their coefficients count both
    for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
      const mesh::Triangle& corners = model.triangles[body.first_triangle + t];
      made.push_back({corners, shares_of(corners, body)});
    }
  }
  return made;
}

}  // namespace weft
