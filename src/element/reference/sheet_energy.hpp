// Energy and forces of a whole sheet in double. Source: docs/elements.md, The reference.
#pragma once

#include <span>
#include <vector>

#include "element/hinge/plate.hpp"
#include "element/membrane/membranes.hpp"
#include "element/reference/sheet.hpp"

namespace weft::reference {

using Places = std::span<const Vec3d>;  // of all nodes [m]

class SheetEnergy {
 public:
  explicit SheetEnergy(Sheet sheet);

  const Sheet& sheet() const { return sheet_; }
  const membrane::Membranes& membranes() const { return membranes_; }
  const hinge::Plate& plate() const { return plate_; }
  const std::vector<double>& mass() const { return mass_; }  // lumped: a third of each triangle's [kg]

  double stretching(Places x) const { return membranes_.energy(x); }  // [J]
  double bending(Places x) const;                                     // [J]
  /// With weight and loads, of which places at rest have none [J].
  double potential(Places x) const;
  double kinetic(std::span<const Vec3d> velocity) const;

  /// Minus the slope of the potential, on every node [N].
  std::vector<Vec3d> forces(Places x) const;
  /// Those of the membranes' delay, by these velocities [N]; they are linear in them, by a symmetric matrix.
  std::vector<Vec3d> damping_forces(Places x, std::span<const Vec3d> velocity) const;

 private:
  Sheet sheet_;
  membrane::Membranes membranes_;
  hinge::Plate plate_;
  std::vector<double> mass_;
};

}  // namespace weft::reference
