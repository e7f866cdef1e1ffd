#include "contact/reference/pushes/analytic.hpp"

namespace weft::reference {
namespace {

template <class Collider>
void add_push(NodePush& push, const Collider& collider, const Vec3d& before, const Vec3d& now,
              const PushLimits& limits) {
  if (surface_at(collider, now).distance >= limits.thickness) return;
  const Surface from = surface_at(collider, before);
  push.sum += push_length(from.distance, limits) * from.normal;
  ++push.count;
}

}  // namespace

Surface surface_at(const scene::ColliderSphere& sphere, const Vec3d& point) {
  const Vec3d offset = point - sphere.center;
  const double distance = length(offset);
  if (distance == 0) return {{0, 1, 0}, -sphere.radius};
  return {offset / distance, distance - sphere.radius};
}

Surface surface_at(const scene::ColliderPlane& plane, const Vec3d& point) {
  return {plane.normal, dot(plane.normal, point - plane.point)};
}

std::vector<NodePush> analytic_pushes(std::span<const Vec3d> previous, std::span<const Vec3d> predicted,
                                      std::span<const double> inverse_mass,
                                      std::span<const scene::ColliderSphere> spheres,
                                      std::span<const scene::ColliderPlane> planes,
                                      const PushLimits& limits) {
  std::vector<NodePush> pushes(previous.size());
  for (std::size_t node = 0; node < previous.size(); ++node) {
    if (inverse_mass[node] == 0) continue;
    for (const auto& sphere : spheres)
      add_push(pushes[node], sphere, previous[node], predicted[node], limits);
    for (const auto& plane : planes) add_push(pushes[node], plane, previous[node], predicted[node], limits);
  }
  return pushes;
}

}  // namespace weft::reference
