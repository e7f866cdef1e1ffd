#include "contact/reference/pushes/response.hpp"

namespace weft::reference {

void respond(std::span<const NodePush> pushes, std::span<const Vec3d> previous, std::span<Vec3d> position,
             std::span<Vec3d> velocity) {
  constexpr double kRestitution = -0.5;
  for (std::size_t node = 0; node < pushes.size(); ++node) {
    if (pushes[node].count == 0) continue;
    position[node] = previous[node] + pushes[node].sum / pushes[node].count;
    velocity[node] *= kRestitution;
  }
}

}  // namespace weft::reference
