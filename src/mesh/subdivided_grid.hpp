// A finer grid through the nodes of a grid: what pictures and exports show of a sheet that was simulated
// coarser.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/grid.hpp"

namespace weft::mesh {

/// The grid whose cells are those of `grid`, halved `level` times.
Grid subdivided(const Grid& grid, std::uint32_t level);

/// One value of a cubic through equally spaced nodes: the sum of weights[k] times node `cell` + k - 1. Where
/// there is no such node its weight is 0.
struct CubicStencil {
  std::uint32_t cell = 0;
  std::array<double, 4> weights{};
};

/// Node `fine` of a row of `nodes` nodes whose cells were halved `level` times. The curve goes through the
/// nodes, and its slope at each is half the difference of its neighbours. In a cell at the rim it is the
/// parabola through the three nodes there; between 2 nodes alone it is straight. Source: Keys, "Cubic
/// convolution interpolation for digital image processing" (1981), with his rim: the error falls as the third
/// power of the spacing everywhere.
CubicStencil cubic_stencil(std::uint32_t fine, std::uint32_t nodes, std::uint32_t level);

/// The nodes of subdivided(grid, level), by cubic_stencil along the rows and the columns.
/// Reads   nodes: those of `grid`, in its order.
std::vector<Vec3d> upsample(const Grid& grid, std::span<const Vec3d> nodes, std::uint32_t level);

}  // namespace weft::mesh
