// The pushes of triangles at convex bodies, in double.
#pragma once

#include <span>
#include <vector>

#include "contact/reference/pushes/convex_body.hpp"
#include "contact/reference/pushes/pushes.hpp"

namespace weft::reference {

/// Of the point that a triangle touches with, a node that has less of it than this gets no push.
inline constexpr double kLeastWeight = 1.0 / 4096;

/// Adds the pushes of every triangle that is nearer than the thickness to a body at its predicted positions: they move
/// its point, from where that was before, to the thickness outside, and are shared by its nodes (docs/collision.md,
/// Convex bodies). Returns the number of such triangles and bodies. Triangles that are not finite have none.
std::size_t add_convex_pushes(std::vector<NodePush>& pushes, std::span<const ConvexBody> bodies,
                              std::span<const mesh::Triangle> cloth_triangles,
                              std::span<const Vec3d> previous, std::span<const Vec3d> predicted,
                              std::span<const double> inverse_mass, const PushLimits& limits);

}  // namespace weft::reference
