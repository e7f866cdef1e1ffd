// What the air does to cloth, as plain loops in double. Source: docs/air.md.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "method/sym3.hpp"
#include "model/air_triangles.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

/// B of a whole triangle's law, whose force is B times `slip`, the velocity of the air over it [m/s]: kg/s. `normal` is
/// as long as twice the area [m²].
Sym3 air_on_triangle(const scene::Air& air, const Vec3d& normal, const Vec3d& slip);

/// The same of each node, with its share of each of its triangles, which are at `place` [m]. Both are by vertex.
std::vector<Sym3> air_on_nodes(const scene::Air& air, std::span<const AirTriangle> triangles,
                               std::span<const Vec3d> place, std::span<const Vec3d> slip);

/// What no eigenvalue of those is above [kg/s].
std::vector<double> most_air_on_nodes(const scene::Air& air, std::span<const AirTriangle> triangles,
                                      std::span<const Vec3d> place, std::span<const Vec3d> slip);

}  // namespace weft::reference
