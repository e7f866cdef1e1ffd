// The forces of a body with volume as plain loops in double. Source: docs/bodies.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "element/tet/tets.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// The tetrahedra of one body. Nodes count from `first`.
struct SolidBody {
  std::uint32_t first = 0, count = 0;
  tet::Tets tets;

  /// Adds the forces of all nodes of the model at these places [m] and velocities [m/s] to `forces` [N].
  void add_forces(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                  std::span<Vec3d> forces) const;
  double energy(std::span<const Vec3d> position) const;  // [J]
};

/// Those of a model's bodies that have volume.
std::vector<SolidBody> solid_bodies(const Model& model);

}  // namespace weft::reference
