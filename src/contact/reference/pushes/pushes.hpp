// The pushes of intersecting pairs, in double.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/pushes/pairs.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::reference {

struct NodePush {
  Vec3d sum;  // [m]
  std::uint32_t count = 0;
};

struct PushLimits {
  double thickness = 0;  // [m]
  double max_push = 0;   // [m]
};

/// (thickness - distance)+, cut to max_push [m].
double push_length(double distance, const PushLimits& limits);

/// For each node the sum of its pushes and their number: each pair pushes the three nodes of its cloth
/// triangle along the object triangle's outward normal, from their previous positions. Source: Sung et al.,
/// Algorithm 2. A node with inverse mass 0 gets none.
std::vector<NodePush> pushes_of(std::span<const TrianglePair> pairs,
                                std::span<const mesh::Triangle> cloth_triangles,
                                std::span<const Vec3d> previous, std::span<const double> inverse_mass,
                                const mesh::TriangleMesh& object, const PushLimits& limits);

}  // namespace weft::reference
