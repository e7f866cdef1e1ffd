#include "bench/round_object.hpp"

#include <algorithm>
#include <cmath>

#include "base/trig.hpp"
#include "mesh/grid.hpp"
#include "mesh/primitives.hpp"

namespace weft::bench {
namespace {

/// How far the surface is from the middle in a direction of length 1 [m].
double surface_radius(const Vec3d& direction) {
  constexpr double kHeight = 0.01, kWave = 10;  // parts of the radius; slopes up to 0.1
  double bumps = 1;
  for (int axis = 0; axis < 3; ++axis) bumps *= turn_of(kWave * direction[axis] + axis).sine;
  return kRoundRadius * (1 + kHeight * bumps);
}

}  // namespace

mesh::TriangleMesh make_round_object(std::uint32_t triangle_count) {
  const int columns = std::max(3, static_cast<int>(std::lround(std::sqrt(0.5 * triangle_count))));
  mesh::TriangleMesh object = mesh::make_sphere(columns, columns + 1);  // 2 * columns² triangles
  for (Vec3f& p : object.positions) {
    const Vec3d direction = p.to<double>() / length(p.to<double>());
    p = (surface_radius(direction) * direction).to<float>();
  }
  return object;
}

mesh::TriangleMesh make_round_sheet(std::uint32_t side, double size, double distance) {
  const mesh::Grid grid{side, side, size, size};
  mesh::TriangleMesh sheet;
  sheet.triangles = mesh::grid_triangles(grid);
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const mesh::RestPoint at = mesh::rest_point(grid, i, j);
      const double x = at.x - 0.5 * size, z = at.y - 0.5 * size, way = std::sqrt(x * x + z * z);
      const Turn turn = turn_of(way / kRoundRadius);
      const double along = way > 0 ? turn.sine / way : 0;
      const Vec3d direction = {along * x, turn.cosine, along * z};
      sheet.positions.push_back(((surface_radius(direction) + distance) * direction).to<float>());
    }
  return sheet;
}

}  // namespace weft::bench
