// A rectangular cloth as a grid of nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Nodes in rows: i from 0 to nx - 1 along the width, j from 0 to ny - 1 along the height.
struct Grid {
  std::uint32_t nx = 2, ny = 2;      // nodes, each at least 2
  double width = 1.0, height = 1.0;  // m
};

/// The most nodes of a grid: six springs and three force components for each stay below 2^32.
constexpr std::uint64_t kMaxGridNodes = std::uint64_t{1} << 28U;

/// Errors  Input: fewer than 2 nodes a side, more than kMaxGridNodes, or a size that is not positive and
/// finite. All functions below expect a grid that passed.
Result<void> check_grid(const Grid& grid);

std::uint32_t node_count(const Grid& grid);

/// Row by row: j * nx + i.
constexpr std::uint32_t node_index(const Grid& grid, std::uint32_t i, std::uint32_t j) {
  return j * grid.nx + i;
}

/// The rest coordinates of a node [m], from the corner i = 0, j = 0.
struct RestPoint {
  double x = 0.0, y = 0.0;  // along the width, along the height
};
RestPoint rest_point(const Grid& grid, std::uint32_t i, std::uint32_t j);

/// Two triangles a quad, quads row by row; the diagonal alternates with i + j, which prefers no direction:
///
///      i ──>
///    j a───b───b'    a = (i, j)      b = (i + 1, j)
///    │ │ ╲ │ ╱ │     c = (i, j + 1)  d = (i + 1, j + 1)
///    v c───d───d'    i + j even: (a c d), (a d b);  odd: (a c b), (b c d)
///
/// counter-clockwise as drawn: with i to the right and j down, the normals point at the reader.
std::vector<Triangle> grid_triangles(const Grid& grid);

}  // namespace weft::mesh
