#include "method/mass_spring/reference/mass_spring_stepper.hpp"

namespace weft::reference {

void MassSpringStepper::advance(const Substep& substep) {
  MassSpringSystem& system = substep.system;
  const std::vector<Vec3d> previous = system.position;
  reference::advance(system, substep.dt);
  for (std::size_t node = 0; node < previous.size(); ++node) {
    if (motion_[node] < 2) continue;  // free or pinned
    system.position[node] = substep.places[node];
    system.velocity[node] = (substep.places[node] - previous[node]) / substep.dt;
  }
}

}  // namespace weft::reference
