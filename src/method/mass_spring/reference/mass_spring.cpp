#include "method/mass_spring/reference/mass_spring.hpp"

#include <cmath>

namespace weft::reference {
namespace {

const Follower* follower(const MassSpringSystem& system, std::size_t node) {
  for (const Follower& held : system.grabs)
    if (held.node == node) return &held;
  return nullptr;
}

Vec3d curvature_of(const MassSpringSystem& system, const BendLink& triple) {
  return (system.position[triple.node_a] - system.position[triple.node_b]) +
         (system.position[triple.node_c] - system.position[triple.node_b]);
}

}  // namespace

std::vector<Vec3d> spring_forces(const MassSpringSystem& system) {
  std::vector<Vec3d> forces(system.position.size());
  for (const SpringLink& spring : system.springs) {
    const Vec3d span = system.position[spring.node_b] - system.position[spring.node_a];
    const double len = length(span);
    if (len == 0) continue;
    const Vec3d direction = span / len;
    const double rate = dot(system.velocity[spring.node_b] - system.velocity[spring.node_a], direction);
    const Vec3d force = (spring.stiffness * (len - spring.rest_length) + spring.damping * rate) * direction;
    forces[spring.node_a] += force;
    forces[spring.node_b] -= force;
  }
  for (const BendLink& triple : system.bending) {
    const Vec3d force = triple.stiffness * curvature_of(system, triple);
    forces[triple.node_a] -= force;
    forces[triple.node_b] += 2 * force;
    forces[triple.node_c] -= force;
  }
  return forces;
}

Vec3d wind_at(const scene::WindField& wind, const Vec3d& place, double time) {
  Vec3d sum = wind.velocity;
  for (const scene::WindWave& wave : wind.waves) {
    const double u = 2 * scene::turn_part(dot(wave.gradient, place) - wave.rate * time) - 1;
    sum += 4 * u * (1 - std::abs(u)) * wave.gust;
  }
  return sum;
}

void advance(MassSpringSystem& system, double dt) {
  const std::vector<Vec3d> forces = spring_forces(system);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (system.inverse_mass[i] == 0) {
      system.velocity[i] = {};
      continue;
    }
    if (const Follower* held = follower(system, i)) {
      Vec3d velocity = system.grab_rate * (held->target - system.position[i]);
      const double speed = length(velocity);
      if (speed > system.grab_speed) velocity *= system.grab_speed / speed;
      system.velocity[i] = velocity;
      system.position[i] += dt * velocity;
      continue;
    }
    const Vec3d slip = system.velocity[i] - wind_at(system.wind, system.position[i], system.time);
    const Vec3d acceleration = system.acceleration + system.inverse_mass[i] * forces[i] - system.drag * slip;
    system.velocity[i] += dt * acceleration;
    system.position[i] += dt * system.velocity[i];
  }
  system.time += dt;
}

double energy(const MassSpringSystem& system) {
  double sum = 0;
  for (std::size_t i = 0; i < system.position.size(); ++i) {
    if (system.inverse_mass[i] == 0) continue;
    const double mass = 1 / system.inverse_mass[i];
    sum += 0.5 * mass * dot(system.velocity[i], system.velocity[i]) -
           mass * dot(system.acceleration, system.position[i]);
  }
  for (const SpringLink& spring : system.springs) {
    const double elongation =
        length(system.position[spring.node_b] - system.position[spring.node_a]) - spring.rest_length;
    sum += 0.5 * spring.stiffness * elongation * elongation;
  }
  for (const BendLink& triple : system.bending) {
    const Vec3d curvature = curvature_of(system, triple);
    sum += 0.5 * triple.stiffness * dot(curvature, curvature);
  }
  return sum;
}

}  // namespace weft::reference
