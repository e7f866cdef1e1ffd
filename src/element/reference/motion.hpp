// A sheet that moves, by implicit time steps of the second order. Source: docs/elements.md, The reference.
#pragma once

#include <memory>
#include <vector>

#include "base/result.hpp"
#include "element/reference/newton_limits.hpp"
#include "element/reference/sheet_energy.hpp"

namespace weft::reference {

enum class Scheme {
  Midpoint,  // the implicit midpoint rule: keeps momentum and angular momentum, and takes no energy
  Bdf2       // damps what is faster than a step; begins with backward Euler
};

struct SheetState {
  std::vector<Vec3d> position, velocity;  // [m], [m/s]
  double time = 0;                        // [s]
};

class Motion {
 public:
  /// Held nodes are placed at the state's time.
  Motion(Sheet sheet, SheetState start, Scheme scheme, NewtonLimits limits = {});
  Motion(Motion&&) noexcept;
  ~Motion();

  /// One step [s].
  /// Errors  Diverged: Newton's method does not reach its limit; the state is that before the step.
  Result<NewtonReport> advance(double dt);

  const SheetEnergy& energy() const;
  const SheetState& state() const;
  /// Potential and kinetic [J].
  double total_energy() const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace weft::reference
