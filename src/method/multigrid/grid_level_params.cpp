#include "method/multigrid/grid_level_params.hpp"

#include "method/multigrid/cycle.hpp"
#include "method/multigrid/grid_levels.hpp"

namespace weft {

std::vector<GridLevelParams> grid_level_params(const Body& body, bool air, std::size_t most) {
  const mesh::Grid& grid = *body.grid;
  const auto [along_i, along_j] = bending_stiffness(body);
  const auto ratio = [](std::uint32_t interval, std::uint32_t last) {
    return static_cast<float>(interval) / static_cast<float>(last);
  };
  std::vector<GridLevelParams> levels;
  std::uint32_t vectors = 0, operators = 0;
  for (const GridLevel& shape : grid_levels(grid.nx, grid.ny)) {
    if (levels.size() == most) break;
    GridLevelParams level;
    level.nx = shape.nx;
    level.ny = shape.ny;
    level.first_vector = vectors;
    level.first_operator = operators;
    level.bending_i = static_cast<float>(along_i * shape.bending_i);
    level.bending_j = static_cast<float>(along_j * shape.bending_j);
    level.last_bend_i = ratio(shape.interval_i, shape.last_i);
    level.last_bend_j = ratio(shape.interval_j, shape.last_j);
    level.rim = body.weights == mesh::BoundaryWeights::Uniform ? 1.0F : 0.5F;
    vectors += multigrid::vector_count(levels.size(), air) * node_count(level);
    if (!levels.empty()) operators += multigrid::kOperatorParts * node_count(level);
    levels.push_back(level);
  }
  for (GridLevelParams& level : levels) {
    level.vectors = vectors;
    level.operators = operators;
  }
  return levels;
}

}  // namespace weft
