#pragma once

#include <cstdint>
#include <vector>

#include "base/mat3.hpp"
#include "element/colors.hpp"
#include "method/projection/multipliers.hpp"
#include "method/reference_ways.hpp"
#include "method/stepper.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// Moves the corners of a tetrahedron, whose nodes count from `first`, to where its energy and damping let them be.
/// `multiplier` is -h² times its stress by volume, by what it pulled with so far in the substep of dt [s] [kg·m²].
/// Source: docs/solvers/xpbd.md, Bodies.
void project_tet(Ways& ways, const tet::Tets& tets, std::size_t tet, std::uint32_t first, double dt,
                 Mat3& multiplier);

/// The tetrahedra of a body with volume as constraints, projected colour after colour.
class SolidProjection {
 public:
  SolidProjection(const Model& model, const Body& body, Multipliers multipliers);

  /// A substep begins: nothing pulls yet.
  void begin();
  /// Forth over the tetrahedra and back, in a substep of dt [s]. `solid` is that of the body.
  void sweep(Ways& ways, const SolidBody& solid, double dt);

 private:
  Multipliers multipliers_;
  Colors tets_;
  std::vector<Mat3> pulled_;  // multipliers [kg·m²]
};

}  // namespace weft::reference
