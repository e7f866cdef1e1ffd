#include "mesh/grid.hpp"

#include <cmath>

namespace weft::mesh {

Result<void> check_grid(const Grid& grid) {
  if (grid.nx < 2 || grid.ny < 2)
    return input_error("Grid %u x %u has a side of fewer than 2 nodes.", grid.nx, grid.ny);
  const std::uint64_t nodes = std::uint64_t{grid.nx} * grid.ny;
  if (nodes > kMaxGridNodes)
    return input_error("Grid %u x %u has %llu nodes, more than the limit of %llu.", grid.nx, grid.ny,
                       static_cast<unsigned long long>(nodes),
                       static_cast<unsigned long long>(kMaxGridNodes));
  for (const double size : {grid.width, grid.height})
    if (!(size > 0.0 && std::isfinite(size)))
      return input_error("Grid %u x %u has the size %g m, which is not positive and finite.", grid.nx,
                         grid.ny, size);
  return {};
}

std::uint32_t node_count(const Grid& grid) { return grid.nx * grid.ny; }

RestPoint rest_point(const Grid& grid, std::uint32_t i, std::uint32_t j) {
  return {i * grid.width / (grid.nx - 1), j * grid.height / (grid.ny - 1)};
}

std::vector<Triangle> grid_triangles(const Grid& grid) {
  std::vector<Triangle> triangles;
  triangles.reserve(2 * std::size_t{grid.nx - 1} * (grid.ny - 1));
  for (std::uint32_t j = 0; j + 1 < grid.ny; ++j)
    for (std::uint32_t i = 0; i + 1 < grid.nx; ++i) {
      const std::uint32_t a = node_index(grid, i, j);
      const std::uint32_t b = a + 1;
      const std::uint32_t c = a + grid.nx;
      const std::uint32_t d = c + 1;
      if ((i + j) % 2 == 0) {
        triangles.push_back({a, c, d});
        triangles.push_back({a, d, b});
      } else {
        triangles.push_back({a, c, b});
        triangles.push_back({b, c, d});
      }
    }
  return triangles;
}

}  // namespace weft::mesh
