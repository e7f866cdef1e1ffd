// The heavy cantilever of a rod that bends by large angles.
#pragma once

#include <cmath>

namespace weft {

/// Clamped level: B φ'' = -w (L - s) λ cos φ with φ(0) = 0, φ'(L) = 0, where φ is the angle below level at the arc
/// length s at rest, and λ = 1 + w (L - s) sin φ / E the stretch. By shooting from the free end, in units of L and B;
/// G = w L³ / B. A rod of softness w L / E = 0 is inextensible.
struct Elastica {
  double load;      // G
  double softness;  // w L / E
  double drop = 0;  // of the tip, by the length

  explicit Elastica(double g, double soft = 0) : load(g), softness(soft) {
    double low = 0, high = std::acos(0.0);
    for (int step = 0; step < 60; ++step) {
      const double tip = (low + high) / 2;
      (angle_at_clamp(tip) > 0 ? high : low) = tip;
    }
  }

 private:
  double stretch(double r, double phi) const { return 1 + softness * r * std::sin(phi); }
  double bent(double r, double phi) const { return -load * r * stretch(r, phi) * std::cos(phi); }
  double sunk(double r, double phi) const { return stretch(r, phi) * std::sin(phi); }

  /// Runge and Kutta's fourth order over r = 1 - s, from the tip to the clamp: d²φ/dr² = -G r λ cos φ.
  double angle_at_clamp(double tip) {
    constexpr int kSteps = 2000;
    const double h = 1.0 / kSteps;
    double phi = tip, rate = 0, r = 0;
    drop = 0;
    for (int i = 0; i < kSteps; ++i, r += h) {
      const double k1 = rate, l1 = bent(r, phi);
      const double k2 = rate + h / 2 * l1, l2 = bent(r + h / 2, phi + h / 2 * k1);
      const double k3 = rate + h / 2 * l2, l3 = bent(r + h / 2, phi + h / 2 * k2);
      const double k4 = rate + h * l3, l4 = bent(r + h, phi + h * k3);
      const double next = phi + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      drop += h / 6 * (sunk(r, phi) + 4 * sunk(r + h / 2, phi + h / 4 * (k1 + k2)) + sunk(r + h, next));
      rate += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
      phi = next;
    }
    return phi;
  }
};

}  // namespace weft
