#include "method/air_reference.hpp"

#include <cmath>

namespace weft::reference {
namespace {

Vec3d normal_of(const mesh::Triangle& t, std::span<const Vec3d> place) {
  return cross(place[t[1]] - place[t[0]], place[t[2]] - place[t[0]]);
}

}  // namespace

Sym3 air_on_triangle(const scene::Air& air, const Vec3d& normal, const Vec3d& slip) {
  const double size = length(normal);
  if (size == 0) return {};
  const Vec3d n = normal / size;
  const double across = dot(n, slip);
  const double friction = air.friction * length(slip);
  const double pressure = air.pressure * std::abs(across) + air.lift * length(slip - across * n);
  return (air.density / 2 * size / 2) * (Sym3::outer(n, pressure - friction) + Sym3::identity(friction));
}

std::vector<Sym3> air_on_nodes(const scene::Air& air, std::span<const AirTriangle> triangles,
                               std::span<const Vec3d> place, std::span<const Vec3d> slip) {
  std::vector<Sym3> sums(place.size());
  for (const auto& [corners, shares] : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sums[corners[k]] += air_on_triangle(air, shares[k] * normal_of(corners, place), slip[corners[k]]);
  return sums;
}

std::vector<double> most_air_on_nodes(const scene::Air& air, std::span<const AirTriangle> triangles,
                                      std::span<const Vec3d> place, std::span<const Vec3d> slip) {
  const double all = air.density / 2 * (air.pressure + air.lift + air.friction);
  std::vector<double> sums(place.size());
  for (const auto& [corners, shares] : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sums[corners[k]] += all * shares[k] * length(normal_of(corners, place)) / 2 * length(slip[corners[k]]);
  return sums;
}

}  // namespace weft::reference
