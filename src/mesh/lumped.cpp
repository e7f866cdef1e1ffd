#include "mesh/lumped.hpp"

namespace weft::mesh {

std::vector<double> vertex_areas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.positions.size(), 0.0);
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].to<double>();
    const Vec3d normal = cross(mesh.positions[t[1]].to<double>() - a, mesh.positions[t[2]].to<double>() - a);
    const double third = length(normal) / 6.0;  // the triangle's area is half of the length
    for (const std::uint32_t vertex : t) areas[vertex] += third;
  }
  return areas;
}

std::vector<double> vertex_areas(const Grid& grid) {
  const double quarter = 0.25 * (grid.width / (grid.nx - 1)) * (grid.height / (grid.ny - 1));  // m²
  std::vector<double> areas;
  areas.reserve(node_count(grid));
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const double columns = i == 0 || i + 1 == grid.nx ? 1.0 : 2.0;
      const double rows = j == 0 || j + 1 == grid.ny ? 1.0 : 2.0;
      areas.push_back(columns * rows * quarter);
    }
  return areas;
}

Result<void> check_vertex_areas(std::span<const double> areas) {
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (!(areas[i] > 0.0))
      return input_error("Vertex %zu of the cloth has the area %g m², so it has no mass.", i, areas[i]);
  return {};
}

}  // namespace weft::mesh
