#include "contact/reference/pushes/pushes.hpp"

#include <algorithm>

namespace weft::reference {

double push_length(double distance, const PushLimits& limits) {
  return std::clamp(limits.thickness - distance, 0.0, limits.max_push);
}

std::vector<NodePush> pushes_of(std::span<const TrianglePair> pairs,
                                std::span<const mesh::Triangle> cloth_triangles,
                                std::span<const Vec3d> previous, std::span<const double> inverse_mass,
                                const mesh::TriangleMesh& object, const PushLimits& limits) {
  std::vector<NodePush> pushes(previous.size());
  for (const TrianglePair& pair : pairs) {
    const TrianglePoints points = points_of(object, pair.object);
    const Vec3d area = cross(points.b - points.a, points.c - points.a);
    const Vec3d normal = area / length(area);
    for (const std::uint32_t node : cloth_triangles[pair.cloth]) {
      if (inverse_mass[node] == 0) continue;
      pushes[node].sum += push_length(dot(normal, previous[node] - points.a), limits) * normal;
      ++pushes[node].count;
    }
  }
  return pushes;
}

}  // namespace weft::reference
