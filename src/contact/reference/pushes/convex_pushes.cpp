#include "contact/reference/pushes/convex_pushes.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

bool all_finite(const TrianglePoints& t) {
  const Vec3d sum = t.a + t.b + t.c;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

/// Along the axis on which the boxes are furthest apart.
double between_boxes(const TrianglePoints& t, const ConvexBody& body) {
  const Vec3d low = min(min(t.a, t.b), t.c), high = max(max(t.a, t.b), t.c);
  const Vec3d between = max(low - body.high, body.low - high);
  return std::max({between.x, between.y, between.z});
}

}  // namespace

std::size_t add_convex_pushes(std::vector<NodePush>& pushes, std::span<const ConvexBody> bodies,
                              std::span<const mesh::Triangle> cloth_triangles,
                              std::span<const Vec3d> previous, std::span<const Vec3d> predicted,
                              std::span<const double> inverse_mass, const PushLimits& limits) {
  std::size_t contacts = 0;
  for (const ConvexBody& body : bodies)
    for (const mesh::Triangle& nodes : cloth_triangles) {
      const TrianglePoints triangle{predicted[nodes[0]], predicted[nodes[1]], predicted[nodes[2]]};
      if (!all_finite(triangle) || between_boxes(triangle, body) > limits.thickness) continue;
      const ConvexContact contact = contact_by_features(triangle, body);
      if (contact.distance >= limits.thickness) continue;
      ++contacts;
      double distance = 0, squares = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight = contact.weights[k];
        distance += weight * dot(contact.normal, previous[nodes[k]] - contact.point);
        if (weight >= kLeastWeight) squares += weight * weight;
      }
      const double push = push_length(distance, limits);
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight = contact.weights[k];
        if (weight < kLeastWeight || inverse_mass[nodes[k]] == 0) continue;
        pushes[nodes[k]].sum += std::min(push * weight / squares, limits.max_push) * contact.normal;
        ++pushes[nodes[k]].count;
      }
    }
  return contacts;
}

}  // namespace weft::reference
