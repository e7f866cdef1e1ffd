#include "element/triple/triple.hpp"

namespace weft {

std::array<double, 2> triple_stiffness(const mesh::Grid& grid, double bending) {
  const double di = grid.width / (grid.nx - 1), dj = grid.height / (grid.ny - 1);
  return {bending * dj / (di * di * di), bending * di / (dj * dj * dj)};
}

std::uint64_t triple_count(const mesh::Grid& grid, double bending) {
  const std::uint64_t nx = grid.nx, ny = grid.ny;
  return bending > 0 ? (nx - 2) * ny + nx * (ny - 2) : 0;
}

ElementTable build_triples(const mesh::Grid& grid, double bending, mesh::BoundaryWeights weights,
                           std::uint32_t first) {
  ElementTable table{ElementKind::Triple, {}, {}, {}};
  if (!(bending > 0)) return table;
  const auto [along_i, along_j] = triple_stiffness(grid, bending);
  const std::uint32_t nx = grid.nx, ny = grid.ny;
  const double rim = weights == mesh::BoundaryWeights::Uniform ? 1 : 0.5;
  const auto add = [&](std::uint32_t node, std::uint32_t stride, double stiffness) {
    table.nodes.insert(table.nodes.end(), {node - stride, node, node + stride});
    table.material.push_back(static_cast<float>(stiffness));
  };
  for (std::uint32_t j = 0; j < ny; ++j)
    for (std::uint32_t i = 1; i + 1 < nx; ++i)
      add(first + j * nx + i, 1, (j == 0 || j + 1 == ny ? rim : 1) * along_i);
  for (std::uint32_t i = 0; i < nx; ++i)
    for (std::uint32_t j = 1; j + 1 < ny; ++j)
      add(first + j * nx + i, nx, (i == 0 || i + 1 == nx ? rim : 1) * along_j);
  return table;
}

}  // namespace weft
