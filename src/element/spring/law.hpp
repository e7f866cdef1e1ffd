// The law of a spring in double: the oracle of src/element/spring/law.wgsl. Source: docs/solvers/mass_spring.md,
// equation 1; docs/solvers/multigrid.md, equation 6.
#pragma once

#include <algorithm>

#include "base/vec.hpp"

namespace weft::spring {

inline constexpr double kMinLength = 1e-9;  // m; a shorter spring has no direction, and pulls nowhere

/// Beyond its longest length a spring is stiffer by this part of its stiffness. Mirror:
/// src/method/multigrid/spring.wgsl.
inline constexpr double kStiffer = 50;

/// A spring's law: Hooke's, with more stiffness beyond a length. Source: docs/solvers/multigrid.md, equation 5a.
struct Law {
  double rest_length = 0;  // [m]
  double stiffness = 0;    // [N/m]
  double longest = 0;      // [m]; 0: as long as it likes
  double more = 0;         // the stiffness that is added beyond that [N/m]

  static Law of(double rest_length, double stiffness, double longest) {
    return {rest_length, stiffness, longest, kStiffer * stiffness};
  }
  /// The spring of Hooke's law that it is like at a length.
  Law at(double length) const {
    if (longest == 0 || length <= longest || more == 0) return {rest_length, stiffness};
    const double sum = stiffness + more;
    return {(stiffness * rest_length + more * longest) / sum, sum};
  }
};

/// Hooke's law and damping along the spring. The force on node a of a spring from a to b is tension * direction.
struct Pull {
  double tension = 0;  // [N]; positive pulls the nodes together
  Vec3d direction;     // unit; 0 where the spring is too short to have one
};
/// `span` from node a to node b [m], `rate` how fast it changes [m/s].
inline Pull pull(const Vec3d& span, const Vec3d& rate, const Law& law, double damping) {
  const double len = length(span);
  if (len < kMinLength) return {};
  const Law now = law.at(len);
  const Vec3d direction = span / len;
  return {now.stiffness * (len - now.rest_length) + damping * dot(rate, direction), direction};
}

/// [J]
inline double energy(const Vec3d& span, const Law& law) {
  const double elongation = length(span) - law.rest_length;
  const double beyond = law.longest > 0 ? std::max(0.0, length(span) - law.longest) : 0;
  return 0.5 * law.stiffness * elongation * elongation + 0.5 * law.more * beyond * beyond;
}

/// How the elastic force changes with the span: along n nᵀ + across I.
struct Block {
  Vec3d direction;               // n
  double along = 0, across = 0;  // [N/m]
};
/// k [(1 - b) n nᵀ + b I] with b = max(0, 1 - l0/l): the Hessian of a stretched spring, and of a pressed one without
/// what would make it indefinite.
inline Block block(const Vec3d& span, const Law& law) {
  const double len = length(span);
  if (len < kMinLength) return {};
  const Law now = law.at(len);
  const double b = std::max(0.0, 1 - now.rest_length / len);
  return {span / len, now.stiffness * (1 - b), now.stiffness * b};
}

}  // namespace weft::spring
