#pragma once

#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "method/reference_ways.hpp"
#include "method/stepper.hpp"

namespace weft::reference {

/// The tetrahedra of a corotated body in a cycle. Source: docs/solvers/projective_dynamics.md, Bodies.
class SolidRelaxation {
 public:
  /// A cycle of a substep of dt [s] begins: adds what they pull the nodes with at the ways so far [N].
  void begin(const SolidBody& solid, const Ways& ways, double dt, std::vector<Vec3d>& pulls);
  /// Adds what their matrix says of a change of the ways [m].
  void add_pulls_of(const SolidBody& solid, const std::vector<Vec3d>& change,
                    std::vector<Vec3d>& pulls) const;

 private:
  /// How fast a stress grows with a change X of F at most: across X + along (R : X) R [Pa].
  struct Turned {
    Mat3 rotation;  // R
    double across = 0, along = 0;
  };
  std::vector<Turned> turned_;
};

}  // namespace weft::reference
