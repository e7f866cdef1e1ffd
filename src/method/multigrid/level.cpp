#include "method/multigrid/level.hpp"

#include <algorithm>
#include <cmath>

#include "method/multigrid/grid_levels.hpp"

namespace weft {

std::vector<MultigridLevel> multigrid_levels(const ClothModel& cloth) {
  const mesh::Grid& grid = *cloth.grid;
  const auto [along_i, along_j] = bending_stiffness(cloth);
  const auto end = [](std::uint32_t side, bool even) {
    return side - std::min(side, even ? 1U : 2U);  // without the inner node of a shorter last interval
  };
  std::vector<MultigridLevel> levels;
  std::uint32_t vectors = 0, operators = 0;
  for (const GridLevel& shape : grid_levels(grid.nx, grid.ny)) {
    MultigridLevel level;
    level.nx = shape.nx;
    level.ny = shape.ny;
    level.first_vector = vectors;
    level.first_operator = operators;
    level.bending_i = static_cast<float>(along_i * shape.bending_i);
    level.bending_j = static_cast<float>(along_j * shape.bending_j);
    level.bend_end_i = end(shape.nx, shape.even_i);
    level.bend_end_j = end(shape.ny, shape.even_j);
    level.rim = cloth.weights == mesh::BoundaryWeights::Uniform ? 1.0F : 0.5F;
    vectors += multigrid::kVectors * level.node_count();
    if (!levels.empty()) operators += multigrid::kOperatorParts * level.node_count();
    levels.push_back(level);
  }
  return levels;
}

SpringGrid spring_grid(const ClothModel& cloth) {
  const mesh::Grid& grid = *cloth.grid;
  const double di = grid.width / (grid.nx - 1), dj = grid.height / (grid.ny - 1);
  SpringGrid made;
  made.first_vertex = cloth.first_vertex;
  made.nx = grid.nx;
  made.ny = grid.ny;
  made.uniform_weights = cloth.weights == mesh::BoundaryWeights::Uniform ? 1 : 0;
  made.stiffness = {static_cast<float>(cloth.stiffness.structural), static_cast<float>(cloth.stiffness.shear),
                    static_cast<float>(cloth.stiffness.bend), 0};
  made.rest_length = {static_cast<float>(di), static_cast<float>(dj),
                      static_cast<float>(std::sqrt(di * di + dj * dj)), 0};
  made.damping = static_cast<float>(cloth.damping);
  return made;
}

}  // namespace weft
