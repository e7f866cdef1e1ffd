#include "method/reference_ways.hpp"

namespace weft::reference {

Ways Ways::begin(const Substep& substep) {
  MassSpringSystem& system = substep.system;
  Ways ways{system.position, {}, system.inverse_mass};
  integrate(system, std::vector<Vec3d>(ways.start.size()), substep.dt);
  for (std::size_t node = 0; node < ways.start.size(); ++node) {
    // Pinned nodes stay: their place is the one that they had.
    const bool kinematic = system.inverse_mass[node] == 0;
    ways.way.push_back((kinematic ? substep.places[node] : system.position[node]) - ways.start[node]);
  }
  for (const Follower& grabbed : system.grabs) ways.inverse_mass[grabbed.node] = 0;
  return ways;
}

void Ways::end(const Substep& substep) const {
  for (std::size_t node = 0; node < way.size(); ++node) {
    substep.system.position[node] = place(node);
    substep.system.velocity[node] = way[node] / substep.dt;
  }
}

}  // namespace weft::reference
