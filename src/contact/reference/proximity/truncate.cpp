#include "contact/reference/proximity/truncate.hpp"

#include <algorithm>

namespace weft::reference {

std::uint32_t truncate(std::span<const SidePlane> planes, std::span<const Vec3d> previous,
                       std::span<const double> inverse_mass, double reach, std::span<Vec3d> position) {
  std::vector<double> part(position.size(), 1);
  for (std::size_t node = 0; node < position.size(); ++node) {
    const double far = length(position[node] - previous[node]);
    if (far > reach) part[node] = reach / far;
  }
  for (const SidePlane& plane : planes) {
    const double before = dot(plane.normal, previous[plane.node]) - plane.offset;
    const double after = dot(plane.normal, position[plane.node]) - plane.offset;
    if (after >= 0) continue;
    if (before > 0)
      part[plane.node] = std::min(part[plane.node], before / (before - after));
    else if (!plane.obstacle && after < before)
      part[plane.node] = 0;
  }
  std::vector<bool> moved(position.size());
  for (std::size_t node = 0; node < position.size(); ++node) {
    if (inverse_mass[node] == 0 || part[node] == 1) continue;
    position[node] = previous[node] + part[node] * (position[node] - previous[node]);
    moved[node] = true;
  }
  for (const SidePlane& plane : planes) {
    if (!plane.obstacle || inverse_mass[plane.node] == 0) continue;
    const double beyond = plane.offset - dot(plane.normal, position[plane.node]);
    // A vertex that the line above has put onto the plane may be a rounding error behind it.
    if (!(beyond > 0)) continue;
    position[plane.node] += beyond * plane.normal;
    moved[plane.node] = true;
  }
  return static_cast<std::uint32_t>(std::count(moved.begin(), moved.end(), true));
}

}  // namespace weft::reference
