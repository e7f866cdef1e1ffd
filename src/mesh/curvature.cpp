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

/// An edge between two triangles that face the same side.
struct Fold {
  std::array<std::uint32_t, 2> ends;
  Vec3d normal;     // of both triangles together, of length 1
  Mat3 turned;      // what each of its ends gets of it [m]
  double turn = 0;  // [rad]
};

/// The folds of a surface, creases too.
std::vector<Fold> folds_of(std::span<const Vec3d> positions, std::span<const Triangle> triangles,
                           std::span<const Vec3d> normals) {
  std::vector<Fold> folds;
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
    const Vec3d normal = first / length(first) + second / length(second), across = cross(edge, normal);
    const double square = dot(across, across);
    if (!(square > 0)) return;  // folded flat
    folds.push_back({{sides[0].nodes[0], sides[0].nodes[1]},
                     normal / length(normal),
                     0.5 * turn * size / square * Mat3::outer(across, across),
                     turn});
  });
  return folds;
}

}  // namespace

std::vector<Curvature> vertex_curvatures(std::span<const Vec3d> positions,
                                         std::span<const Triangle> triangles) {
  std::vector<Curvature> at(positions.size());
  std::vector<Vec3d> normals;  // of triangles, as long as twice their areas
  for (const Triangle& t : triangles) {
    normals.push_back(cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]));
    for (const std::uint32_t v : t) at[v].normal += normals.back();
  }
  const std::vector<Fold> folds = folds_of(positions, triangles, normals);
  std::vector<bool> creased(at.size());
  std::vector<Vec3d> curved(at.size());  // normals of folds that are no creases, by how far they turn
  for (const Fold& fold : folds)
    for (const std::uint32_t end : fold.ends) {
      if (std::abs(fold.turn) < kCrease) {
        curved[end] += std::abs(fold.turn) * fold.normal;
      } else {
        creased[end] = true;
      }
    }
  for (std::size_t v = 0; v < at.size(); ++v) {
    Vec3d& normal = at[v].normal;
    if (creased[v] && length(curved[v]) > 0) normal = curved[v];
    if (length(normal) > 0) normal = normal / length(normal);
  }
  const auto belongs = [&](std::uint32_t v, const Vec3d& normal) {
    return !creased[v] || dot(at[v].normal, normal) > kSameSector * length(normal);
  };
  std::vector<double> area(at.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!(length(normals[t]) > 0)) continue;
    const auto [a, b, c] = triangles[t];
    const std::array<double, 3> parts = corner_areas({positions[a], positions[b], positions[c]});
    for (std::size_t k = 0; k < 3; ++k)
      if (belongs(triangles[t][k], normals[t])) area[triangles[t][k]] += parts[k];
  }
  for (const Fold& fold : folds)
    for (const std::uint32_t end : fold.ends)
      if (std::abs(fold.turn) < kCrease && belongs(end, fold.normal)) at[end].shape += fold.turned;
  for (std::size_t v = 0; v < at.size(); ++v) at[v].shape = area[v] > 0 ? 1 / area[v] * at[v].shape : Mat3{};
  return at;
}

}  // namespace weft::mesh
