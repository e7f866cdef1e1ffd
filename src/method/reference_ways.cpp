#include "method/reference_ways.hpp"

#include <algorithm>

namespace weft::reference {

Ways Ways::begin(const Substep& substep) {
  MassSpringSystem& system = substep.system;
  Ways ways{system.position, {}, system.inverse_mass};
  const double left_by_drag = 1 / (1 + substep.dt * system.drag);
  integrate(system, gas_forces(system, ways.start), substep.dt, left_by_drag);
  for (double& inverse_mass : ways.inverse_mass) inverse_mass *= left_by_drag;
  for (std::size_t node = 0; node < ways.start.size(); ++node) {
    // Pinned nodes stay: their place is the one that they had.
    const bool kinematic = system.inverse_mass[node] == 0;
    ways.way.push_back((kinematic ? substep.places[node] : system.position[node]) - ways.start[node]);
  }
  for (const auto& [node, target] : system.grabs) ways.inverse_mass[node] = 0;
  return ways;
}

void Ways::end(const Substep& substep) const {
  for (std::size_t node = 0; node < way.size(); ++node) {
    substep.system.position[node] = place(node);
    substep.system.velocity[node] = way[node] / substep.dt;
  }
}

Ways LookBack::begin(const Substep& substep, std::vector<Vec3d>& aim) {
  const double dt = substep.dt;
  const std::vector<Vec3d> velocity = substep.system.velocity;
  Ways ways = Ways::begin(substep);
  aim = ways.way;
  for (std::size_t node = 0; node < aim.size(); ++node) {
    const Vec3d change = aim[node] - dt * velocity[node];
    const double square = dot(change, change);
    if (ways.inverse_mass[node] == 0 || !known_[node] || substep.ratio == 0 || square == 0) continue;
    const Vec3d felt = dt * substep.ratio * (velocity[node] - velocity_before_[node]);
    ways.way[node] = dt * velocity[node] + std::clamp(dot(felt, change) / square, 0.0, 1.0) * change;
  }
  velocity_before_ = velocity;
  known_.assign(known_.size(), true);
  return ways;
}

}  // namespace weft::reference
