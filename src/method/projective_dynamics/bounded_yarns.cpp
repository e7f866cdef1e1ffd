#include "method/projective_dynamics/bounded_yarns.hpp"

#include <algorithm>
#include <cmath>

namespace weft::bounded_yarns {
namespace {

/// These two: src/method/projective_dynamics/bounded_yarns.wgsl.
constexpr double kCouplesTo = 1.5;  // the stretch from which on a yarn pulls less and less at the other one
constexpr double kCouples = 0.5;    // by how much more stretch, until no more

/// Of the second derivative, in units of |C12| and C33: docs/solvers/projective_dynamics.md, equation 13.
constexpr double kMostCoupled = 1.3, kMostCoupledAuxetic = 2;
constexpr double kMostSheared = 2.48832;

/// A yarn's direction, and what of it counts where both yarns act together. Equations 11 and 12.
struct Yarn {
  explicit Yarn(const Vec3d& f) : stretch(length(f)) {
    direction = 1 / std::max(stretch, membrane::kMinStretch) * f;
    if (stretch < 1) {
      coupling = (stretch * stretch - 1) / 2;
      coupling_slope = stretch;
      across = (3 - stretch * stretch) / 2;
      along = stretch * stretch;
    } else {
      const double beyond = std::clamp(stretch - kCouplesTo, 0.0, kCouples);
      coupling = std::min(stretch, kCouplesTo) - 1 + beyond - beyond * beyond / (2 * kCouples);
      coupling_slope = 1 - beyond / kCouples;
      across = along = 1 / stretch;
    }
    arrow = across * f;
  }
  /// (∂ arrow / ∂ F)ᵀ other
  Vec3d turned(const Vec3d& other) const {
    return across * other - (along * dot(direction, other)) * direction;
  }

  double stretch;
  Vec3d direction, arrow;
  double coupling, coupling_slope;
  double across, along;  // of the arrow's slope
};

}  // namespace

double energy(const Stiffness& c, const membrane::Axes& f) {
  const Yarn warp(f.warp), weft(f.weft);
  const double x = warp.stretch - 1, y = weft.stretch - 1, cosine = dot(warp.arrow, weft.arrow);
  return (c.warp * x * x + c.weft * y * y + c.shear * cosine * cosine) / 2 +
         c.coupled * warp.coupling * weft.coupling;
}

membrane::Axes stress(const membrane::Law& law, const membrane::Axes& f, const membrane::Axes& rate) {
  const Stiffness& c = law.stiffness;
  const Yarn warp(f.warp), weft(f.weft);
  const Vec3d at_warp = warp.turned(weft.arrow), at_weft = weft.turned(warp.arrow);
  const double warp_rate = law.delay * dot(warp.direction, rate.warp),
               weft_rate = law.delay * dot(weft.direction, rate.weft);
  const double sheared = c.shear * (dot(warp.arrow, weft.arrow) +
                                    law.delay * (dot(at_warp, rate.warp) + dot(at_weft, rate.weft)));
  const double along_warp =
      c.warp * (warp.stretch - 1 + warp_rate) + c.coupled * (weft.coupling * warp.coupling_slope + weft_rate);
  const double along_weft =
      c.weft * (weft.stretch - 1 + weft_rate) + c.coupled * (warp.coupling * weft.coupling_slope + warp_rate);
  return {along_warp * warp.direction + sheared * at_warp, along_weft * weft.direction + sheared * at_weft};
}

Bound bound(const Stiffness& c) {
  const double both =
      (c.coupled > 0 ? kMostCoupled : -kMostCoupledAuxetic) * c.coupled + kMostSheared * c.shear;
  return {c.warp + both, c.weft + both};
}

}  // namespace weft::bounded_yarns
