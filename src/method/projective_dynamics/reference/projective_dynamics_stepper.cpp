#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"

#include <algorithm>

#include "element/spring/law.hpp"

namespace weft::reference {
namespace {

/// What every spring pulls its nodes with: tensions at the ways so far [N].
std::vector<Vec3d> pulls(const MassSpringSystem& system, const Ways& ways, double dt) {
  std::vector<Vec3d> pulls(ways.way.size());
  for (const SpringLink& s : system.springs) {
    const Vec3d turn = ways.way[s.node_b] - ways.way[s.node_a];
    const Vec3d span = ways.start[s.node_b] - ways.start[s.node_a] + turn;
    const spring::Pull pull = spring::pull(span, turn / dt, s.law(), s.damping);
    pulls[s.node_a] += pull.tension * pull.direction;
    pulls[s.node_b] -= pull.tension * pull.direction;
  }
  return pulls;
}

/// By how much those of projected springs grow with a change of the ways, -L change [N].
std::vector<Vec3d> pulls_of_change(const MassSpringSystem& system, const std::vector<Vec3d>& change,
                                   double dt) {
  std::vector<Vec3d> pulls(change.size());
  for (const SpringLink& s : system.springs) {
    const Vec3d pull = (s.stiffness + s.damping / dt) * (change[s.node_b] - change[s.node_a]);
    pulls[s.node_a] += pull;
    pulls[s.node_b] -= pull;
  }
  return pulls;
}

}  // namespace

ProjectiveDynamicsStepper::ProjectiveDynamicsStepper(const Model& model, double step,
                                                     std::uint32_t iterations)
    : look_back_(model.rest_position.size()) {
  double most = 0;
  for (const Body& cloth : model.bodies) {
    const SpringRates rates = spring_rates(model, cloth);
    rates_of_.insert(rates_of_.end(), cloth.vertex_count, rates);
    most = std::max(most, rates.at(step));
  }
  relaxation_ = make_relaxation(most, iterations);
}

void ProjectiveDynamicsStepper::advance(const Substep& substep) {
  const double dt = substep.dt;
  std::vector<Vec3d> aim;
  Ways ways = look_back_.begin(substep, aim);
  std::vector<Vec3d> left(aim.size()), change(aim.size());
  const auto relax = [&](std::size_t node, double weight) {
    change[node] =
        weight * relaxation_.gain(rates_of_[node].at(dt)) * left[node] + (weight - 1) * change[node];
    ways.way[node] += change[node];
  };
  for (const std::vector<double>& weights : relaxation_.cycles) {
    const std::vector<Vec3d> force = pulls(substep.system, ways, dt);
    for (std::size_t node = 0; node < aim.size(); ++node) {
      left[node] = {};
      if (ways.inverse_mass[node] > 0)
        left[node] = aim[node] - ways.way[node] + dt * dt * ways.inverse_mass[node] * force[node];
      relax(node, 1);
    }
    for (const double weight : weights) {
      const std::vector<Vec3d> more = pulls_of_change(substep.system, change, dt);
      for (std::size_t node = 0; node < aim.size(); ++node) {
        left[node] += dt * dt * ways.inverse_mass[node] * more[node] - change[node];
        relax(node, weight);
      }
    }
  }
  ways.end(substep);
}

}  // namespace weft::reference
