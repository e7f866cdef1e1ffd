// What cloth bears in its plane. Source: docs/tearing.md.
#pragma once

#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "model/model.hpp"

namespace weft {

/// The tension of each node of a cloth, force per width at rest, as a symmetric matrix along the axes of the world
/// [N/m]: the mean of its triangles', weighted by their areas. Of fabric a triangle has its Biot stress, of springs
/// half of what its edges and those springs that cross them bear, times their lengths at rest and by its area. Damping
/// bears nothing in it.
/// Reads   position: of all the model's nodes [m].
std::vector<Mat3> tensions(const Model& model, const Body& body, std::span<const Vec3d> position);

/// The largest eigenvalue of a symmetric matrix, and its unit eigenvector.
struct Principal {
  double value = 0;
  Vec3d direction;
};
Principal largest_principal(const Mat3& symmetric);

}  // namespace weft
