// The gas in closed cloths, as plain loops in double. Source: docs/pressure.md.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "element/gas/law.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// What one cloth encloses. Nodes count through the model.
struct EnclosedGas {
  std::vector<mesh::Triangle> triangles;
  gas::Law law;

  double volume(std::span<const Vec3d> places) const;  // [m³]
  /// What it has more than at rest [J].
  double energy(std::span<const Vec3d> places) const { return law.energy(volume(places)); }
  /// Adds the forces on all nodes at these places to `forces` [N].
  void add_forces(std::span<const Vec3d> places, std::span<Vec3d> forces) const;
};

/// Of the cloths that enclose a gas, in the order of the scene.
std::vector<EnclosedGas> enclosed_gases(const Model& model);

}  // namespace weft::reference
