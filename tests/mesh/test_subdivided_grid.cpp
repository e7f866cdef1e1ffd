#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "base/random.hpp"
#include "mesh/subdivided_grid.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

/// A place on the sheet, each in [0, 1], to the world.
using Shape = std::function<Vec3d(double, double)>;

std::vector<Vec3d> sampled(const Grid& grid, const Shape& shape) {
  std::vector<Vec3d> nodes;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i)
      nodes.push_back(shape(static_cast<double>(i) / (grid.nx - 1), static_cast<double>(j) / (grid.ny - 1)));
  return nodes;
}

/// How far the upsampled sheet is from the shape itself, at worst.
double error_of(const Grid& grid, const Shape& shape, std::uint32_t level) {
  const std::vector<Vec3d> found = upsample(grid, sampled(grid, shape), level);
  const std::vector<Vec3d> exact = sampled(subdivided(grid, level), shape);
  REQUIRE(found.size() == exact.size());
  double most = 0;
  for (std::size_t v = 0; v < found.size(); ++v) most = std::max(most, length(found[v] - exact[v]));
  return most;
}

}  // namespace

TEST_CASE("a grid whose cells are halved keeps its size and its rim") {
  const Grid fine = subdivided({32, 5, 2.0, 1.5}, 3);
  CHECK(fine.nx == 31 * 8 + 1);
  CHECK(fine.ny == 4 * 8 + 1);
  CHECK(fine.width == 2.0);
  CHECK(fine.height == 1.5);
}

TEST_CASE("the weights of every vertex add to 1, and those of missing nodes are 0") {
  for (const std::uint32_t nodes : {2U, 3U, 4U, 9U})
    for (std::uint32_t level = 1; level <= 4; ++level)
      for (std::uint32_t fine = 0; fine <= (nodes - 1) << level; ++fine) {
        const CubicStencil s = cubic_stencil(fine, nodes, level);
        CHECK(s.weights[0] + s.weights[1] + s.weights[2] + s.weights[3] ==
              1);  // of dyadic numbers: not rounded
        CHECK(s.cell + 2 <= nodes);
        if (s.cell == 0) CHECK(s.weights[0] == 0);
        if (s.cell + 2 == nodes) CHECK(s.weights[3] == 0);
      }
}

TEST_CASE("upsampling leaves the nodes where they are, to the bit") {
  Random random(3);
  const Grid grid{7, 4};
  std::vector<Vec3d> nodes(28);
  for (Vec3d& node : nodes) node = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  for (std::uint32_t level = 1; level <= 4; ++level) {
    const std::vector<Vec3d> fine = upsample(grid, nodes, level);
    const std::uint32_t row = subdivided(grid, level).nx;
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i)
        CHECK(fine[(j << level) * row + (i << level)] == nodes[node_index(grid, i, j)]);
  }
}

TEST_CASE("an affine sheet is reproduced for every size, and a paraboloid from three nodes a side on") {
  const Shape plane = [](double u, double v) { return Vec3d{1 + 2 * u - v, 3 * v, 0.5 * u + 0.25 * v - 2}; };
  const Shape paraboloid = [](double u, double v) { return Vec3d{u, v, u * u - 3 * u * v + 2 * v * v + u}; };
  for (const Grid grid : {Grid{2, 2}, Grid{2, 5}, Grid{3, 4}, Grid{12, 7}})
    for (std::uint32_t level = 1; level <= 4; ++level) {
      CHECK(error_of(grid, plane, level) < 1e-14);
      if (grid.nx > 2) CHECK(error_of(grid, paraboloid, level) < 1e-14);
    }
}

TEST_CASE("a cylinder's error falls as the third power of the spacing, at the rim too") {
  const Shape cylinder = [](double u, double v) {
    return Vec3d{std::cos(2 * u + 0.3), v, std::sin(2 * u + 0.3)};
  };
  double before = error_of({9, 9}, cylinder, 3);
  CHECK(before < 1.1e-3);  // m, of a radius of 1 m; straight between nodes 0.25 rad apart it is 8e-3
  for (const std::uint32_t nodes : {17U, 33U, 65U}) {
    const double error = error_of({nodes, 9}, cylinder, 3);
    CHECK(before / error > 7.5);
    before = error;
  }
}
