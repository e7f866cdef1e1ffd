// Energy and forces of a whole sheet in double. Source: docs/elements.md, The reference.
#pragma once

#include <span>
#include <vector>

#include "element/hinge/plate.hpp"
#include "element/reference/sheet.hpp"

namespace weft::reference {

using Places = std::span<const Vec3d>;  // of all nodes [m]

class SheetEnergy {
 public:
  explicit SheetEnergy(Sheet sheet);

  const Sheet& sheet() const { return sheet_; }
  const std::vector<membrane::Rest>& rests() const { return rests_; }
  const hinge::Plate& plate() const { return plate_; }
  const std::vector<double>& mass() const { return mass_; }  // lumped: a third of each triangle's [kg]

  double stretching(Places x) const;  // [J]
  double bending(Places x) const;     // [J]
  /// With weight and loads, of which places at rest have none [J].
  double potential(Places x) const;
  double kinetic(std::span<const Vec3d> velocity) const;

  /// Minus the slope of the potential, on every node [N].
  std::vector<Vec3d> forces(Places x) const;
  /// Those of the membranes' delay, by these velocities [N]; they are linear in them, by a symmetric matrix.
  std::vector<Vec3d> damping_forces(Places x, std::span<const Vec3d> velocity) const;

  membrane::Axes deformation(std::size_t triangle, Places x) const {
    const auto& [a, b, c] = sheet_.triangles[triangle];
    return membrane::deformation(rests_[triangle], {x[a], x[b], x[c]});
  }

 private:
  Sheet sheet_;
  std::vector<membrane::Rest> rests_;
  hinge::Plate plate_;
  std::vector<double> mass_;
};

}  // namespace weft::reference
