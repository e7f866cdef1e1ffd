#include "method/projective_dynamics/bounded_yarns.hpp"

#include <algorithm>
#include <cmath>

namespace weft::bounded_yarns {
namespace {

/// These two: src/method/projective_dynamics/bounded_yarns.wgsl.
constexpr double kCouplesTo = 1.5;  // the stretch from which on a yarn pulls less and less at the other one
constexpr double kCouples = 0.5;    // by how much more stretch, until no more

/// Of a second derivative, in units of |C12|, where that is below 0, and of C33.
struct Most {
  double coupled, auxetic, sheared;
};
constexpr Most kMostOfEnergy = {1.3, 2, 2.48832}, kMostOfDamping = {2.5, 3, 2.81};

Bound bound_by(const Most& most, const Stiffness& c) {
  const double both = (c.coupled > 0 ? most.coupled : -most.auxetic) * c.coupled + most.sheared * c.shear;
  return {c.warp + both, c.weft + both};
}

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

membrane::Axes stress(const membrane::Law& law, const membrane::Axes& f, const membrane::Axes& start,
                      double rate) {
  const Stiffness& c = law.stiffness;
  const Yarn warp(f.warp), weft(f.weft), warp_before(start.warp), weft_before(start.weft);
  const double delays = law.delay * rate;
  const auto delayed = [&](double now, double before) { return now + delays * (now - before); };
  const double cosine = dot(warp.arrow, weft.arrow);
  const double sheared = c.shear * delayed(cosine, dot(warp_before.arrow, weft_before.arrow));
  const double along_warp = c.warp * delayed(warp.stretch - 1, warp_before.stretch - 1) +
                            c.coupled * delayed(weft.coupling, weft_before.coupling) * warp.coupling_slope;
  const double along_weft = c.weft * delayed(weft.stretch - 1, weft_before.stretch - 1) +
                            c.coupled * delayed(warp.coupling, warp_before.coupling) * weft.coupling_slope;
  return {along_warp * warp.direction + sheared * warp.turned(weft.arrow),
          along_weft * weft.direction + sheared * weft.turned(warp.arrow)};
}

Bound bound(const Stiffness& c) { return bound_by(kMostOfEnergy, c); }
Bound damping_bound(const Stiffness& c) { return bound_by(kMostOfDamping, c); }

}  // namespace weft::bounded_yarns
