#include <cmath>

#include "mesh/springs.hpp"

namespace weft::mesh {

std::uint64_t grid_spring_count(const Grid& grid) {
  const std::uint64_t nx = grid.nx;
  const std::uint64_t ny = grid.ny;
  const std::uint64_t structural = (nx - 1) * ny + nx * (ny - 1);
  const std::uint64_t shear = 2 * (nx - 1) * (ny - 1);
  const std::uint64_t bend = (nx - 2) * ny + nx * (ny - 2);
  return structural + shear + bend;
}

std::vector<MeshSpring> grid_springs(const Grid& grid, BoundaryWeights weights) {
  const double dx = grid.width / (grid.nx - 1);   // m
  const double dy = grid.height / (grid.ny - 1);  // m
  const double diagonal = std::sqrt(dx * dx + dy * dy);
  const double edge_weight = weights == BoundaryWeights::Area ? 0.5 : 1.0;
  std::vector<MeshSpring> springs;
  springs.reserve(static_cast<std::size_t>(grid_spring_count(grid)));
  for (std::uint32_t j = 0; j < grid.ny; ++j) {
    const double row_weight = j == 0 || j + 1 == grid.ny ? edge_weight : 1.0;
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const double column_weight = i == 0 || i + 1 == grid.nx ? edge_weight : 1.0;
      const std::uint32_t node = node_index(grid, i, j);
      const std::uint32_t below = node + grid.nx;
      const bool right = i + 1 < grid.nx;
      const bool down = j + 1 < grid.ny;
      if (right) springs.push_back({node, node + 1, SpringKind::Structural, dx, row_weight});
      if (down) springs.push_back({node, below, SpringKind::Structural, dy, column_weight});
      if (right && down) {
        springs.push_back({node, below + 1, SpringKind::Shear, diagonal, 1.0});
        springs.push_back({node + 1, below, SpringKind::Shear, diagonal, 1.0});
      }
      if (i + 2 < grid.nx) springs.push_back({node, node + 2, SpringKind::Bend, 2.0 * dx, row_weight});
      if (j + 2 < grid.ny)
        springs.push_back({node, below + grid.nx, SpringKind::Bend, 2.0 * dy, column_weight});
    }
  }
  return springs;
}

}  // namespace weft::mesh
