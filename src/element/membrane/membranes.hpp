// The membranes of a sheet, one a triangle, in double. Source: docs/elements.md, Membrane.
#pragma once

#include <span>
#include <vector>

#include "element/membrane/law.hpp"

namespace weft::membrane {

/// Places and velocities are those of the sheet's nodes [m], [m/s].
struct Membranes {
  std::vector<mesh::Triangle> triangles;
  std::vector<Rest> rests;  // of the triangles
  Law law;

  static Membranes of(const RestSheet& sheet, const Law& law);

  Axes deformation(std::size_t triangle, std::span<const Vec3d> x) const {
    const auto& [a, b, c] = triangles[triangle];
    return membrane::deformation(rests[triangle], {x[a], x[b], x[c]});
  }
  double energy(std::span<const Vec3d> x) const;  // [J]
  /// Adds what they do to the nodes [N].
  void add_forces(std::span<const Vec3d> x, std::span<Vec3d> forces) const;
  /// The same of their damping, which is linear in the velocities, by a symmetric matrix.
  void add_damping_forces(std::span<const Vec3d> x, std::span<const Vec3d> velocity,
                          std::span<Vec3d> forces) const;

 private:
  void add(std::size_t triangle, const Axes& stress, std::span<Vec3d> forces) const;
};

}  // namespace weft::membrane
