// Newton's method for the least value of a sheet's potential, or of what a time step makes of it. Source:
// docs/elements.md, The reference.
#pragma once

#include <vector>

#include "base/result.hpp"
#include "element/reference/newton_limits.hpp"
#include "element/reference/sheet_matrix.hpp"

namespace weft::reference {

/// What a time step adds: x' = from + h v' and v' = v + h a(x', v'), so that x' has the least value of
///   potential + m/(2 h²) |x' - from - h v|² + m drag/(2 h) |x' - from|² + the membranes' damping by (x' - from)/h.
struct Increment {
  double h = 0;             // [s]; 0: nothing, the sheet comes to rest
  std::vector<Vec3d> from;  // [m]
  std::vector<Vec3d> v;     // [m/s]
};

class Newton {
 public:
  explicit Newton(const SheetEnergy& energy);

  /// Moves the free nodes of x.
  /// Errors  Diverged: the residual stays above its limit.
  Result<NewtonReport> solve(const Increment& increment, const NewtonLimits& limits, std::vector<Vec3d>& x);

  /// Whether every small move of free nodes raises the potential.
  bool stable(Places x);

 private:
  bool factor(const Matrix& matrix);
  std::vector<Vec3d> velocities(const Increment& increment, Places x) const;
  std::vector<Vec3d> forces(const Increment& increment, Places x) const;
  double largest(std::span<const Vec3d> forces) const;
  double value(const Increment& increment, Places x, Places damping_at) const;
  bool go(const Increment& increment, const Eigen::VectorXd& way, const Eigen::VectorXd& force,
          std::vector<Vec3d>& x) const;
  bool step(const Increment& increment, Curvature curvature, const Eigen::VectorXd& force,
            std::vector<Vec3d>& x);

  const SheetEnergy& energy_;
  Unknowns unknowns_;
  SheetMatrix matrix_;
  Eigen::SimplicialLDLT<Matrix> factored_;
  Eigen::Index analysed_ = -1;  // how many entries the matrices have whose places are known
};

}  // namespace weft::reference
