#include "mesh/curvature.hpp"

#include <cmath>

#include "mesh/sides.hpp"

namespace weft::mesh {
namespace {

/// The parts of a triangle's area that its corners have: what is nearest to each, or where it is obtuse half for the
/// obtuse corner and a quarter for the others.
std::array<double, 3> corner_areas(const std::array<Vec3d, 3>& x) {
  const double twice = length(cross(x[1] - x[0], x[2] - x[0]));
  std::array<double, 3> square{}, cosine{};  // of the side across a corner; at a corner, times both its sides
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d u = x[(k + 1) % 3] - x[k], v = x[(k + 2) % 3] - x[k], across = u - v;
    square[k] = dot(across, across);
    cosine[k] = dot(u, v);
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (cosine[k] < 0) {
      std::array<double, 3> areas{twice / 8, twice / 8, twice / 8};
      areas[k] = twice / 4;
      return areas;
    }
  std::array<double, 3> areas{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t b = (k + 1) % 3, c = (k + 2) % 3;
    areas[k] = (square[b] * cosine[b] + square[c] * cosine[c]) / (8 * twice);
  }
  return areas;
}

}  // namespace

std::vector<Curvature> vertex_curvatures(std::span<const Vec3d> positions,
                                         std::span<const Triangle> triangles) {
  std::vector<Curvature> at(positions.size());
  std::vector<double> area(positions.size());
  std::vector<Vec3d> normals;  // of triangles, as long as twice their areas
  for (const Triangle& t : triangles) {
    const std::array<Vec3d, 3> x{positions[t[0]], positions[t[1]], positions[t[2]]};
    normals.push_back(cross(x[1] - x[0], x[2] - x[0]));
    if (!(length(normals.back()) > 0)) continue;
    const std::array<double, 3> parts = corner_areas(x);
    for (std::size_t k = 0; k < 3; ++k) {
      at[t[k]].normal += normals.back();
      area[t[k]] += parts[k];
    }
  }
  for_each_edge(sorted_sides(triangles), [&](std::span<const Side> sides) {
    if (sides.size() != 2) return;
    const auto way = [&](const Side& side) { return triangles[side.triangle][side.start()]; };
    const std::uint32_t from = way(sides[0]), to = way(sides[1]);
    if (from == to) return;  // they face opposite sides
    const Vec3d edge = positions[to] - positions[from], first = normals[sides[0].triangle],
                second = normals[sides[1].triangle];
    const double size = length(edge);
    if (!(size > 0 && length(first) > 0 && length(second) > 0)) return;
    const double turn = std::atan2(dot(cross(first, second), edge) / size, dot(first, second));
    if (!(std::abs(turn) < kCrease)) return;
    const Vec3d normal = first / length(first) + second / length(second), across = cross(edge, normal);
    const Mat3 turned = 0.5 * turn * size / dot(across, across) * Mat3::outer(across, across);
    for (const std::uint32_t end : sides[0].nodes) at[end].shape += turned;
  });
  for (std::size_t v = 0; v < at.size(); ++v) {
    const double size = length(at[v].normal);
    if (size > 0) at[v].normal = at[v].normal / size;
    at[v].shape = area[v] > 0 ? 1 / area[v] * at[v].shape : Mat3{};
  }
  return at;
}

}  // namespace weft::mesh
