// The law of a spring in double: the oracle of src/element/spring/law.wgsl. Source: docs/solvers/mass_spring.md,
// equation 1; docs/solvers/multigrid.md, equation 6.
#pragma once

#include <algorithm>

#include "base/vec.hpp"

namespace weft::spring {

inline constexpr double kMinLength = 1e-9;  // m; a shorter spring has no direction, and pulls nowhere

/// Hooke's law and damping along the spring. The force on node a of a spring from a to b is tension * direction.
struct Pull {
  double tension = 0;  // [N]; positive pulls the nodes together
  Vec3d direction;     // unit; 0 where the spring is too short to have one
};
/// `span` from node a to node b [m], `rate` how fast it changes [m/s].
inline Pull pull(const Vec3d& span, const Vec3d& rate, double rest_length, double stiffness, double damping) {
  const double len = length(span);
  if (len < kMinLength) return {};
  const Vec3d direction = span / len;
  return {stiffness * (len - rest_length) + damping * dot(rate, direction), direction};
}

/// [J]
inline double energy(const Vec3d& span, double rest_length, double stiffness) {
  const double elongation = length(span) - rest_length;
  return 0.5 * stiffness * elongation * elongation;
}

/// How the elastic force changes with the span: along n nᵀ + across I.
struct Block {
  Vec3d direction;               // n
  double along = 0, across = 0;  // [N/m]
};
/// k [(1 - b) n nᵀ + b I] with b = max(0, 1 - l0/l): the Hessian of a stretched spring, and of a pressed one without
/// what would make it indefinite.
inline Block block(const Vec3d& span, double rest_length, double stiffness) {
  const double len = length(span);
  if (len < kMinLength) return {};
  const double b = std::max(0.0, 1 - rest_length / len);
  return {span / len, stiffness * (1 - b), stiffness * b};
}

}  // namespace weft::spring
