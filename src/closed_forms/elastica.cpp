#include "closed_forms/elastica.hpp"

#include <cmath>

namespace weft {

Elastica::Elastica(double load, double softness, double rise) : load_(load), softness_(softness) {
  double low = -rise, high = std::acos(0.0);
  for (int step = 0; step < 60; ++step) {
    const double tip = (low + high) / 2;
    (angle_at_clamp(tip) > -rise ? high : low) = tip;
  }
}

double Elastica::stretch(double r, double phi) const { return 1 + softness_ * r * std::sin(phi); }
double Elastica::bent(double r, double phi) const { return -load_ * r * stretch(r, phi) * std::cos(phi); }

/// Runge and Kutta's fourth order over r = 1 - s, from the tip to the clamp: d²φ/dr² = -G r λ cos φ.
double Elastica::angle_at_clamp(double tip) {
  constexpr int kSteps = 2000;
  const double h = 1.0 / kSteps;
  double phi = tip, rate = 0, r = 0;
  drop = reach = 0;
  for (int i = 0; i < kSteps; ++i, r += h) {
    const double k1 = rate, l1 = bent(r, phi);
    const double k2 = rate + h / 2 * l1, l2 = bent(r + h / 2, phi + h / 2 * k1);
    const double k3 = rate + h / 2 * l2, l3 = bent(r + h / 2, phi + h / 2 * k2);
    const double k4 = rate + h * l3, l4 = bent(r + h, phi + h * k3);
    const double next = phi + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), middle = phi + h / 4 * (k1 + k2);
    const double here = stretch(r, phi), half = stretch(r + h / 2, middle), end = stretch(r + h, next);
    drop += h / 6 * (here * std::sin(phi) + 4 * half * std::sin(middle) + end * std::sin(next));
    reach += h / 6 * (here * std::cos(phi) + 4 * half * std::cos(middle) + end * std::cos(next));
    rate += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    phi = next;
  }
  return phi;
}

}  // namespace weft
