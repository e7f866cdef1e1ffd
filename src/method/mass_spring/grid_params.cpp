#include "method/mass_spring/grid_params.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

std::uint32_t tiles_of(std::uint32_t nodes, std::uint32_t width) { return (nodes + width - 1) / width; }

}  // namespace

GridParams grid_params(const ClothModel& cloth, std::uint32_t workgroup_size) {
  const mesh::Grid& grid = *cloth.grid;
  const double di = grid.width / (grid.nx - 1);
  const double dj = grid.height / (grid.ny - 1);
  const scene::Stiffness& stiffness = cloth.stiffness;
  const auto damping = [&](double of_kind) { return static_cast<float>(of_kind > 0 ? cloth.damping : 0); };
  GridParams params;
  params.first_vertex = cloth.first_vertex;
  params.nx = grid.nx;
  params.ny = grid.ny;
  params.uniform_weights = cloth.weights == mesh::BoundaryWeights::Uniform ? 1 : 0;
  params.stiffness = {static_cast<float>(stiffness.structural), static_cast<float>(stiffness.shear),
                      static_cast<float>(stiffness.bend), 0};
  params.damping = {damping(stiffness.structural), damping(stiffness.shear), damping(stiffness.bend), 0};
  params.rest_length = {static_cast<float>(di), static_cast<float>(dj),
                        static_cast<float>(std::sqrt(di * di + dj * dj)), 0};
  const auto bending = bending_stiffness(cloth);
  params.bending = {static_cast<float>(bending[0]), static_cast<float>(bending[1])};
  const std::uint32_t narrow = std::min(32U, workgroup_size), wide = std::min(64U, workgroup_size);
  params.tile_width = tiles_of(grid.nx, wide) * wide > tiles_of(grid.nx, narrow) * narrow ? narrow : wide;
  params.tiles_x = tiles_of(grid.nx, params.tile_width);
  return params;
}

std::vector<gpu::Constant> grid_constants(const ClothModel& cloth) {
  return {{"kDamped", cloth.damping > 0 ? 1.0 : 0.0},
          {"kBend", cloth.stiffness.bend > 0 ? 1.0 : 0.0},
          {"kBending", cloth.stiffness.bending > 0 ? 1.0 : 0.0}};
}

}  // namespace weft
