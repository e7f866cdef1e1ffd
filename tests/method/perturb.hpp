// Cloth in double, moved at random.
#pragma once

#include <cstdint>

#include "base/random.hpp"
#include "method/stepper.hpp"

namespace weft {

/// Moves the free nodes of a system by up to `amount` [m] along each axis, and their velocities by up to `speed` [m/s].
/// Each draws its numbers, also where it is held.
inline void perturb(reference::MassSpringSystem& system, std::uint64_t seed, double amount, double speed) {
  Random random(seed);
  const auto draw = [&](double size) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    return Vec3d{x, y, random.uniform(-size, size)};
  };
  for (std::size_t v = 0; v < system.position.size(); ++v) {
    const Vec3d move = draw(amount), push = draw(speed);
    if (system.inverse_mass[v] == 0) continue;
    system.position[v] += move;
    system.velocity[v] += push;
  }
}

}  // namespace weft
