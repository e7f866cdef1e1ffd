// Spheres and planes as colliders, in double.
#pragma once

#include <span>

#include "contact/reference/pushes/pushes.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

struct Surface {
  Vec3d normal;         // outward, unit
  double distance = 0;  // signed [m]
};
/// At the centre of a sphere the normal is +y.
Surface surface_at(const scene::ColliderSphere& sphere, const Vec3d& point);
Surface surface_at(const scene::ColliderPlane& plane, const Vec3d& point);

/// The pushes of all nodes whose predicted position is within `thickness` of a surface.
std::vector<NodePush> analytic_pushes(std::span<const Vec3d> previous, std::span<const Vec3d> predicted,
                                      std::span<const double> inverse_mass,
                                      std::span<const scene::ColliderSphere> spheres,
                                      std::span<const scene::ColliderPlane> planes, const PushLimits& limits);

}  // namespace weft::reference
