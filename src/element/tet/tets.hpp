// The tetrahedra of a body, in double. Source: docs/bodies.md, The laws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "element/table.hpp"
#include "element/tet/law.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::tet {

/// Places and velocities are those of the body's nodes [m], [m/s].
struct Tets {
  std::vector<mesh::Tet> tets;
  std::vector<Rest> rests;
  Law law;

  static Tets of(std::span<const Vec3d> rest_position, std::span<const mesh::Tet> tets, const Law& law);

  Corners corners(std::size_t tet, std::span<const Vec3d> x) const {
    const auto& [a, b, c, d] = tets[tet];
    return {x[a], x[b], x[c], x[d]};
  }
  Mat3 deformation(std::size_t tet, std::span<const Vec3d> x) const {
    return tet::deformation(rests[tet], corners(tet, x));
  }
  double energy(std::span<const Vec3d> x) const;  // [J]
  /// Adds what they do to the nodes [N].
  void add_forces(std::span<const Vec3d> x, std::span<Vec3d> forces) const;
  /// The same of their damping, which is linear in the velocities, by a symmetric matrix.
  void add_damping_forces(std::span<const Vec3d> x, std::span<const Vec3d> velocity,
                          std::span<Vec3d> forces) const;

 private:
  void add(std::size_t tet, const Mat3& stress, std::span<Vec3d> forces) const;
};

/// As rows of a table: four nodes; rest: the slopes of the last three corners' shape functions [1/m], volume [m³];
/// material: µ, λ [Pa] and the delay of damping [s]. Nodes are numbered from `first`.
ElementTable build_tets(const Tets& tets, std::uint32_t first);

}  // namespace weft::tet
