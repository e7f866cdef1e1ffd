#include "mesh/subdivided_grid.hpp"

#include <algorithm>
#include <cassert>

namespace weft::mesh {
namespace {

Vec3d sum_of(const CubicStencil& stencil, const Vec3d* nodes, std::size_t stride) {
  Vec3d sum;
  for (std::uint32_t k = 0; k < 4; ++k)
    if (const double weight = stencil.weights[k]; weight != 0)
      sum += weight * nodes[(stencil.cell + k - 1) * stride];
  return sum;
}

}  // namespace

Grid subdivided(const Grid& grid, std::uint32_t level) {
  return {((grid.nx - 1) << level) + 1, ((grid.ny - 1) << level) + 1, grid.width, grid.height};
}

CubicStencil cubic_stencil(std::uint32_t fine, std::uint32_t nodes, std::uint32_t level) {
  const std::uint32_t cell = std::min(fine >> level, nodes - 2);
  const double t = static_cast<double>(fine - (cell << level)) / (1U << level);
  std::array<double, 4> w = {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2,
                             ((4 - 3 * t) * t + 1) * t / 2, (t - 1) * t * t / 2};
  const bool first = cell == 0, last = cell + 2 == nodes;
  if (first && last) {  // the missing nodes lie on the line: 2 a - b
    w = {0, w[1] + 2 * w[0] - w[3], w[2] + 2 * w[3] - w[0], 0};
  } else if (first) {  // on the parabola: 3 a - 3 b + c
    w = {0, w[1] + 3 * w[0], w[2] - 3 * w[0], w[3] + w[0]};
  } else if (last) {
    w = {w[0] + w[3], w[1] - 3 * w[3], w[2] + 3 * w[3], 0};
  }
  return {cell, w};
}

std::vector<Vec3d> upsample(const Grid& grid, std::span<const Vec3d> nodes, std::uint32_t level) {
  assert(nodes.size() == node_count(grid));
  const Grid fine = subdivided(grid, level);
  std::vector<Vec3d> rows(std::size_t{fine.nx} *
                          grid.ny);  // fine along the rows, as before along the columns
  for (std::uint32_t i = 0; i < fine.nx; ++i) {
    const CubicStencil stencil = cubic_stencil(i, grid.nx, level);
    for (std::size_t j = 0; j < grid.ny; ++j)
      rows[j * fine.nx + i] = sum_of(stencil, nodes.data() + j * grid.nx, 1);
  }
  std::vector<Vec3d> all(std::size_t{fine.nx} * fine.ny);
  for (std::uint32_t j = 0; j < fine.ny; ++j) {
    const CubicStencil stencil = cubic_stencil(j, grid.ny, level);
    for (std::size_t i = 0; i < fine.nx; ++i)
      all[j * fine.nx + i] = sum_of(stencil, rows.data() + i, fine.nx);
  }
  return all;
}

}  // namespace weft::mesh
