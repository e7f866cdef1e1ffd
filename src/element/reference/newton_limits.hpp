// What Newton's method is to reach, and what it took.
#pragma once

namespace weft::reference {

struct NewtonLimits {
  double residual = 1e-6;  // force left on any free node, by its mass [m/s²]
  int steps = 400;
};

struct NewtonReport {
  int steps = 0;
  int positive_steps = 0;  // of them, with the positive matrix in place of the exact one
  double residual = 0;     // [m/s²]
};

}  // namespace weft::reference
