#include "bench/detail.hpp"

#include <cmath>
#include <numbers>

namespace weft::bench {
namespace {

/// Σ |a - b|²
double squares(std::span<const Vec3d> a, std::span<const Vec3d> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vec3d d = a[k] - b[k];
    sum += dot(d, d);
  }
  return sum;
}

double length_of(const Chain& chain, std::span<const Vec3d> x) {
  double sum = 0;
  for (std::size_t k = 1; k < chain.size(); ++k) sum += length(x[chain[k]] - x[chain[k - 1]]);
  return sum;
}

}  // namespace

double position_error(std::span<const Vec3d> x, std::span<const Vec3d> reference,
                      std::span<const Vec3d> start) {
  return std::sqrt(squares(x, reference) / squares(reference, start));
}

std::vector<Vec3d> vertex_normals(std::span<const Vec3d> x, std::span<const mesh::Triangle> triangles) {
  std::vector<Vec3d> normals(x.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3d twice_area = cross(x[b] - x[a], x[c] - x[a]);
    for (const std::uint32_t vertex : {a, b, c}) normals[vertex] += twice_area;
  }
  for (Vec3d& normal : normals) {
    const double size = length(normal);
    normal = size > 0 ? normal / size : Vec3d{};
  }
  return normals;
}

double mean_normal_angle(std::span<const Vec3d> x, std::span<const Vec3d> reference,
                         std::span<const mesh::Triangle> triangles) {
  const std::vector<Vec3d> a = vertex_normals(x, triangles), b = vertex_normals(reference, triangles);
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double sine = length(cross(a[k], b[k])), cosine = dot(a[k], b[k]);
    // The arc cosine alone would round angles below 1e-8 to nothing.
    sum += sine == 0 && cosine == 0 ? std::numbers::pi / 2 : std::atan2(sine, cosine);
  }
  return sum / static_cast<double>(a.size()) * 180 / std::numbers::pi;
}

std::vector<Chain> free_sides(const Model& model, const Body& body) {
  const mesh::Grid& grid = *body.grid;
  std::vector<Chain> sides;
  for (const std::uint32_t i : {0U, grid.nx - 1}) {
    Chain chain;
    for (std::uint32_t j = 0; j < grid.ny; ++j) {
      const std::uint32_t node = body.first_vertex + mesh::node_index(grid, i, j);
      if (model.kinematic(node)) chain.clear();
      chain.push_back(node);
    }
    sides.push_back(std::move(chain));
  }
  return sides;
}

double stretch_of(std::span<const Chain> chains, std::span<const Vec3d> x, std::span<const Vec3d> rest) {
  double now = 0, at_rest = 0;
  for (const Chain& chain : chains) {
    now += length_of(chain, x);
    at_rest += length_of(chain, rest);
  }
  return at_rest > 0 ? now / at_rest - 1 : 0;
}

double kinetic_energy(std::span<const double> mass, std::span<const Vec4f> velocity) {
  double sum = 0;
  for (std::size_t k = 0; k < mass.size(); ++k) {
    const Vec3d v = velocity[k].xyz().to<double>();
    sum += mass[k] * dot(v, v) / 2;
  }
  return sum;
}

}  // namespace weft::bench
