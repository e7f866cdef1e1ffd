#include "method/mass_spring/reference/mass_spring.hpp"

#include <cmath>

#include "element/spring/law.hpp"
#include "method/air_reference.hpp"

namespace weft::reference {
namespace {

Vec3d curvature_of(const MassSpringSystem& system, const BendLink& triple) {
  return (system.position[triple.node_a] - system.position[triple.node_b]) +
         (system.position[triple.node_c] - system.position[triple.node_b]);
}

}  // namespace

std::vector<Vec3d> spring_forces(const MassSpringSystem& system) {
  std::vector<Vec3d> forces(system.position.size());
  for (const SpringLink& s : system.springs) {
    const spring::Pull pull =
        spring::pull(system.position[s.node_b] - system.position[s.node_a],
                     system.velocity[s.node_b] - system.velocity[s.node_a], s.law(), s.damping);
    const Vec3d force = pull.tension * pull.direction;
    forces[s.node_a] += force;
    forces[s.node_b] -= force;
  }
  for (const BendLink& triple : system.bending) {
    const Vec3d force = triple.stiffness * curvature_of(system, triple);
    forces[triple.node_a] -= force;
    forces[triple.node_b] += 2 * force;
    forces[triple.node_c] -= force;
  }
  for (const FabricCloth& cloth : system.fabrics) cloth.add_forces(system.position, system.velocity, forces);
  for (const SolidBody& body : system.solids) body.add_forces(system.position, system.velocity, forces);
  return forces;
}

void yield(MassSpringSystem& system) {
  for (FabricCloth& cloth : system.fabrics) cloth.yield(system.position);
}

std::vector<Vec3d> gas_forces(const MassSpringSystem& system, std::span<const Vec3d> places) {
  std::vector<Vec3d> forces(places.size());
  for (const EnclosedGas& gas : system.gases) gas.add_forces(places, forces);
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

std::optional<Vec3d> grab_velocity(const MassSpringSystem& system, std::size_t node) {
  const auto grabbed = system.grabs.find(static_cast<std::uint32_t>(node));
  if (grabbed == system.grabs.end()) return std::nullopt;
  Vec3d velocity = system.grab_rate * (grabbed->second - system.position[node]);
  const double speed = length(velocity);
  if (speed > system.grab_speed) velocity *= system.grab_speed / speed;
  return velocity;
}

/// What the air resists with at each node, as a step begins [kg/s]; empty: there is none.
static std::vector<Sym3> air_of(const MassSpringSystem& system) {
  if (!system.air) return {};
  std::vector<Vec3d> slip;
  for (std::size_t i = 0; i < system.position.size(); ++i)
    slip.push_back(wind_at(system.wind, system.position[i], system.time) - system.velocity[i]);
  return air_on_nodes(*system.air, system.triangles, system.position, slip);
}

void integrate(MassSpringSystem& system, const std::vector<Vec3d>& forces, double dt, double left_by_drag) {
  const std::vector<Sym3> air = air_of(system);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (system.inverse_mass[i] == 0) {
      system.velocity[i] = {};
      continue;
    }
    if (const auto velocity = grab_velocity(system, i)) {
      system.velocity[i] = *velocity;
      system.position[i] += dt * *velocity;
      continue;
    }
    const Vec3d wind = wind_at(system.wind, system.position[i], system.time);
    const Vec3d slip = system.velocity[i] - wind;
    const Vec3d acceleration = system.acceleration + system.inverse_mass[i] * forces[i] - system.drag * slip;
    system.velocity[i] += dt * left_by_drag * acceleration;
    if (system.air) {
      const Sym3 share = dt * system.inverse_mass[i] * air[i];
      system.velocity[i] += inverse(Sym3::identity(1) + share) * (share * (wind - system.velocity[i]));
    }
    system.position[i] += dt * system.velocity[i];
  }
  system.time += dt;
}

void advance(MassSpringSystem& system, double dt) {
  yield(system);
  std::vector<Vec3d> forces = spring_forces(system);
  for (const EnclosedGas& gas : system.gases) gas.add_forces(system.position, forces);
  integrate(system, forces, dt);
}

EnergySums energies(const MassSpringSystem& system) {
  EnergySums sums;
  for (std::size_t i = 0; i < system.position.size(); ++i) {
    if (system.inverse_mass[i] == 0) continue;
    const double mass = 1 / system.inverse_mass[i];
    sums.kinetic += 0.5 * mass * dot(system.velocity[i], system.velocity[i]);
    sums.potential -= mass * dot(system.acceleration, system.position[i]);
  }
  for (const SpringLink& s : system.springs)
    sums.springs += spring::energy(system.position[s.node_b] - system.position[s.node_a], s.law());
  for (const BendLink& triple : system.bending) {
    const Vec3d curvature = curvature_of(system, triple);
    sums.bending += 0.5 * triple.stiffness * dot(curvature, curvature);
  }
  for (const FabricCloth& cloth : system.fabrics) {
    sums.membranes += cloth.stretching(system.position);
    sums.bending += cloth.bending(system.position);
  }
  for (const SolidBody& body : system.solids) sums.tetrahedra += body.energy(system.position);
  for (const EnclosedGas& gas : system.gases) sums.gas += gas.energy(system.position);
  return sums;
}

}  // namespace weft::reference
