#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/adjacency.hpp"
#include "mesh/grid.hpp"
#include "mesh/lumped.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

// On the drawing of grid.hpp: i to the right, j down, normals at the reader.
TriangleMesh drawn(const Grid& grid) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const RestPoint p = rest_point(grid, i, j);
      mesh.positions.push_back(Vec3d{p.x, -p.y, 0.0}.to<float>());
    }
  mesh.triangles = grid_triangles(grid);
  return mesh;
}

}  // namespace

TEST_CASE("a grid's triangles cover it once, all facing the reader") {
  const Grid grid{5, 4, 2.0, 1.5};
  const TriangleMesh mesh = drawn(grid);
  REQUIRE(mesh.triangles.size() == 2 * 4 * 3);
  REQUIRE(check_mesh(mesh));
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3f normal =
        cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    CHECK(normal.z > 0.0F);
    area += 0.5 * static_cast<double>(normal.z);
  }
  CHECK(area == doctest::Approx(3.0));
  CHECK(mesh_edges(mesh.triangles).size() == 4 * 4 + 5 * 3 + 4 * 3);  // rows, columns, one diagonal a quad
}

TEST_CASE("the diagonals of neighbouring quads alternate") {
  const std::vector<Triangle> triangles = grid_triangles({3, 3, 1.0, 1.0});
  CHECK(triangles[0] == Triangle{0, 3, 4});  // a c d
  CHECK(triangles[1] == Triangle{0, 4, 1});  // a d b
  CHECK(triangles[2] == Triangle{1, 4, 2});  // a c b
  CHECK(triangles[3] == Triangle{2, 4, 5});  // b c d
  const Adjacency at = triangle_adjacency(9, triangles);
  CHECK(at.row(4).size() == 8);  // all four diagonals meet in the middle
  CHECK(at.row(0).size() == 2);
  CHECK(at.row(1).size() == 2);
}

TEST_CASE("rest points reach from the first corner to the last") {
  const Grid grid{4, 3, 3.0, 1.0};
  CHECK(rest_point(grid, 0, 0).x == 0.0);
  CHECK(rest_point(grid, 1, 1).x == doctest::Approx(1.0));
  CHECK(rest_point(grid, 1, 1).y == doctest::Approx(0.5));
  CHECK(rest_point(grid, 3, 2).x == 3.0);
  CHECK(rest_point(grid, 3, 2).y == 1.0);
  CHECK(node_index(grid, 3, 2) == node_count(grid) - 1);
}

TEST_CASE("grids that are too small, too large or have no size are refused") {
  CHECK(check_grid({2, 2, 1.0, 1.0}));
  CHECK(check_grid({1 << 14, 1 << 14, 1.0, 1.0}));
  CHECK(check_grid({1, 5, 1.0, 1.0}).error().message == "Grid 1 x 5 has a side of fewer than 2 nodes.");
  CHECK(check_grid({(1 << 14) + 1, 1 << 14, 1.0, 1.0}).error().message ==
        "Grid 16385 x 16384 has 268451840 nodes, more than the limit of 268435456.");
  CHECK_FALSE(check_grid({65536, 65536, 1.0, 1.0}));  // 2^32: zero in 32 bits
  for (const double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(check_grid({3, 3, size, 1.0}));
    CHECK_FALSE(check_grid({3, 3, 1.0, size}));
  }
}

TEST_CASE("a grid's node areas add up to its area") {
  const Grid grid{7, 4, 2.0, 3.0};
  const std::vector<double> areas = vertex_areas(grid);
  REQUIRE(areas.size() == 28);
  CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == doctest::Approx(6.0).epsilon(1e-14).scale(0));
  const double cell = 2.0 / 6 * 3.0 / 3;
  CHECK(areas[0] == doctest::Approx(0.25 * cell));
  CHECK(areas[1] == doctest::Approx(0.5 * cell));
  CHECK(areas[7] == doctest::Approx(0.5 * cell));
  CHECK(areas[8] == doctest::Approx(cell));
}

TEST_CASE("a mesh's vertex areas add up to its area, and a vertex without any is named") {
  TriangleMesh mesh = drawn({6, 5, 2.0, 1.0});
  std::vector<double> areas = vertex_areas(mesh);
  CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == doctest::Approx(2.0).epsilon(1e-6).scale(0));
  CHECK(check_vertex_areas(areas));
  mesh.positions.push_back({9, 9, 9});
  mesh.positions.push_back({8, 8, 8});
  areas = vertex_areas(mesh);
  CHECK(check_vertex_areas(areas).error().kind == ErrorKind::Input);
  CHECK(check_vertex_areas(areas).error().message ==
        "Vertex 30 of the cloth has the area 0 m², so it has no mass.");
}
