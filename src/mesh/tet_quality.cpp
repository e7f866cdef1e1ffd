#include "mesh/tet_quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::mesh {
namespace {

// Between the sides of the edge from a to b that go on to c and to d [degrees].
double dihedral_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  constexpr double kDegrees = 57.29577951308232;
  const Vec3d along = b - a;
  const Vec3d to_c = cross(along, c - a), to_d = cross(along, d - a);  // both turned by 90° about the edge
  return kDegrees * std::atan2(length(cross(to_c, to_d)), dot(to_c, to_d));
}

}  // namespace

TetQuality tet_quality(const TetMesh& mesh) {
  static constexpr std::size_t kEdges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                               {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  if (mesh.tets.empty()) return {};
  constexpr double kMax = std::numeric_limits<double>::infinity();
  TetQuality quality{kMax, -kMax, kMax, -kMax, 0};
  for (const Tet& tet : mesh.tets) {
    std::array<Vec3d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.positions[tet[k]].to<double>();
    const double volume = six_volumes(corners) / 6;
    quality.volume += volume;
    quality.least_volume = std::min(quality.least_volume, volume);
    quality.largest_volume = std::max(quality.largest_volume, volume);
    for (const auto& [a, b, c, d] : kEdges) {
      const double angle = dihedral_angle(corners[a], corners[b], corners[c], corners[d]);
      quality.least_angle = std::min(quality.least_angle, angle);
      quality.largest_angle = std::max(quality.largest_angle, angle);
    }
  }
  return quality;
}

}  // namespace weft::mesh
