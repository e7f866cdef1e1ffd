#include "closed_forms/catenary.hpp"

#include <cmath>

namespace weft {

double catenary_sag(double length, double span) {
  double low = 1e-6, high = 50;  // u = span/2a: sinh(u)/u rises from 1
  for (int step = 0; step < 100; ++step) {
    const double u = (low + high) / 2;
    (std::sinh(u) / u > length / span ? high : low) = u;
  }
  return span / (2 * low) * (std::cosh(low) - 1);
}

}  // namespace weft
