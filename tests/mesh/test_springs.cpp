#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "mesh/springs.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::size_t count_of(const std::vector<MeshSpring>& springs, SpringKind kind) {
  return static_cast<std::size_t>(
      std::count_if(springs.begin(), springs.end(), [&](const MeshSpring& s) { return s.kind == kind; }));
}

double weight_of(const std::vector<MeshSpring>& springs, SpringKind kind) {
  double sum = 0.0;
  for (const MeshSpring& s : springs)
    if (s.kind == kind) sum += s.weight;
  return sum;
}

std::map<Pair, MeshSpring> by_pair(const std::vector<MeshSpring>& springs) {
  std::map<Pair, MeshSpring> map;
  for (const MeshSpring& s : springs) {
    CHECK(s.node_a < s.node_b);
    CHECK(map.emplace(Pair{s.node_a, s.node_b}, s).second);  // no pair twice
  }
  return map;
}

TriangleMesh grid_mesh(const Grid& grid) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i)
      mesh.positions.push_back(Vec3d{rest_point(grid, i, j).x, 0.0, rest_point(grid, i, j).y}.to<float>());
  mesh.triangles = grid_triangles(grid);
  return mesh;
}

// Every quad split along a-d.
TriangleMesh one_diagonal_mesh(const Grid& grid) {
  TriangleMesh mesh = grid_mesh(grid);
  mesh.triangles.clear();
  for (std::uint32_t j = 0; j + 1 < grid.ny; ++j)
    for (std::uint32_t i = 0; i + 1 < grid.nx; ++i) {
      const std::uint32_t a = node_index(grid, i, j), b = a + 1, c = a + grid.nx, d = c + 1;
      mesh.triangles.push_back({a, c, d});
      mesh.triangles.push_back({d, b, a});
    }
  return mesh;
}

}  // namespace

TEST_CASE("a grid has the springs that its size gives in closed form") {
  for (const auto& [nx, ny] : {std::pair{2U, 2U}, {2U, 5U}, {3U, 2U}, {7U, 4U}, {10U, 10U}, {33U, 17U}}) {
    const Grid grid{nx, ny, 2.0, 3.0};
    const auto springs = grid_springs(grid, BoundaryWeights::Area);
    CHECK(count_of(springs, SpringKind::Structural) == (nx - 1) * ny + nx * (ny - 1));
    CHECK(count_of(springs, SpringKind::Shear) == 2 * (nx - 1) * (ny - 1));
    CHECK(count_of(springs, SpringKind::Bend) == (nx - 2) * ny + nx * (ny - 2));
    CHECK(springs.size() == grid_spring_count(grid));
    for (const auto& [pair, s] : by_pair(springs)) {
      const RestPoint a = rest_point(grid, pair.first % nx, pair.first / nx);
      const RestPoint b = rest_point(grid, pair.second % nx, pair.second / nx);
      CHECK(s.rest_length == doctest::Approx(std::hypot(b.x - a.x, b.y - a.y)).epsilon(1e-12).scale(0));
    }
  }
  // 2N(N-1) + 2(N-1)² + 2N(N-2) = 6N² - 10N + 2
  CHECK(grid_spring_count({100, 100, 1.0, 1.0}) == 6 * 100 * 100 - 10 * 100 + 2);
  CHECK(grid_spring_count({1 << 14, 1 << 14, 1.0, 1.0}) < (1ULL << 32));
}

TEST_CASE("a grid's springs weigh as the cloth beside them, or one each") {
  const Grid grid{9, 6, 2.0, 1.0};  // each row stands for a strip of cloth: ny - 1 strips in all
  const auto springs = grid_springs(grid, BoundaryWeights::Area);
  CHECK(weight_of(springs, SpringKind::Structural) == 2 * 8 * 5);
  CHECK(weight_of(springs, SpringKind::Shear) == 2 * 8 * 5);
  CHECK(weight_of(springs, SpringKind::Bend) == 7 * 5 + 8 * 4);
  const auto uniform = grid_springs(grid, BoundaryWeights::Uniform);
  CHECK(std::all_of(uniform.begin(), uniform.end(), [](const MeshSpring& s) { return s.weight == 1.0; }));
  CHECK(uniform.size() == springs.size());
}

TEST_CASE("a grid's springs follow its nodes row by row, and at a node their kind") {
  using enum SpringKind;
  const auto springs = grid_springs({3, 3, 2.0, 2.0}, BoundaryWeights::Area);
  const std::tuple<std::uint32_t, std::uint32_t, SpringKind, double> expected[] = {
      {0, 1, Structural, 0.5}, {0, 3, Structural, 0.5}, {0, 4, Shear, 1.0},      {1, 3, Shear, 1.0},
      {0, 2, Bend, 0.5},       {0, 6, Bend, 0.5},       {1, 2, Structural, 0.5}, {1, 4, Structural, 1.0},
      {1, 5, Shear, 1.0},      {2, 4, Shear, 1.0},      {1, 7, Bend, 1.0}};
  for (std::size_t i = 0; i < std::size(expected); ++i)
    CHECK(std::tuple(springs[i].node_a, springs[i].node_b, springs[i].kind, springs[i].weight) ==
          expected[i]);
}

TEST_CASE("a triangulated grid has exactly the grid's structural and shear springs") {
  for (const Grid grid :
       {Grid{6, 6, 1.0, 1.0}, Grid{9, 4, 8.0, 3.0}, Grid{5, 7, 1.0, 9.0}, Grid{2, 2, 1.0, 1.0}})
    for (const TriangleMesh& mesh : {grid_mesh(grid), one_diagonal_mesh(grid)})
      for (const BoundaryWeights weights : {BoundaryWeights::Area, BoundaryWeights::Uniform}) {
        auto expected = by_pair(grid_springs(grid, weights));
        std::erase_if(expected, [](const auto& entry) { return entry.second.kind == SpringKind::Bend; });
        auto springs = by_pair(mesh_springs(mesh, weights));
        std::erase_if(springs, [](const auto& entry) { return entry.second.kind == SpringKind::Bend; });
        REQUIRE(springs.size() == expected.size());
        for (const auto& [pair, s] : springs) {
          REQUIRE(expected.contains(pair));
          CHECK(s.kind == expected[pair].kind);
          CHECK(s.weight == expected[pair].weight);
          CHECK(s.rest_length == doctest::Approx(expected[pair].rest_length).epsilon(1e-6).scale(0));
        }
      }
}

TEST_CASE("two triangles with equal sides have no diagonal, but a bend spring across") {
  //   2 ─── 3     the height of an equilateral triangle of side 1 is √3/2, so 0 and 3 are √3 apart
  //  ╱ ╲   ╱
  // 0 ── 1
  const float height = std::sqrt(0.75F);
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5F, height, 0}, {1.5F, height, 0}},
                          {{0, 1, 2}, {1, 3, 2}}};
  const auto springs = mesh_springs(mesh, BoundaryWeights::Area);
  CHECK(springs.size() == 6);
  CHECK(count_of(springs, SpringKind::Structural) == 5);
  CHECK(weight_of(springs, SpringKind::Structural) == 4 * 0.5 + 1);
  CHECK(springs[2].node_b == 3);  // (0, 3) is the third pair in order
  CHECK(springs[2].kind == SpringKind::Bend);
  CHECK(springs[2].rest_length == doctest::Approx(std::sqrt(3.0)));
}

TEST_CASE("an edge of three triangles has a bend spring between neighbours, in order") {
  // Three wings at the edge 0-1, whose own sides are longer than the edge.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5F, 1, 0}, {0.5F, 0, 1}, {0.5F, -1, 0}},
                          {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const auto springs = by_pair(mesh_springs(mesh, BoundaryWeights::Area));
  CHECK(springs.size() == 7 + 2);
  CHECK(springs.at({2, 3}).kind == SpringKind::Bend);
  CHECK(springs.at({3, 4}).kind == SpringKind::Bend);
  CHECK_FALSE(springs.contains({2, 4}));
  CHECK(springs.at({0, 1}).weight == 1.0);
  CHECK(springs.at({0, 2}).weight == 0.5);
}

TEST_CASE("only a long edge between exactly two triangles is a diagonal") {
  // A right angle at 2 in every triangle, opposite to the edge 0-1.
  TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}}, {{0, 1, 2}}};
  CHECK(by_pair(mesh_springs(mesh, BoundaryWeights::Area)).at({0, 1}).kind == SpringKind::Structural);
  mesh.triangles.push_back({1, 0, 3});
  auto springs = by_pair(mesh_springs(mesh, BoundaryWeights::Area));
  CHECK(springs.at({0, 1}).kind == SpringKind::Shear);
  CHECK(springs.at({2, 3}).kind == SpringKind::Shear);
  mesh.triangles.push_back({0, 1, 4});
  springs = by_pair(mesh_springs(mesh, BoundaryWeights::Area));
  CHECK(springs.at({0, 1}).kind == SpringKind::Structural);
  CHECK(springs.at({2, 3}).kind == SpringKind::Bend);
  CHECK(springs.at({3, 4}).kind == SpringKind::Bend);
}

TEST_CASE("a bend spring is dropped where the mesh has an edge already, and pieces stay apart") {
  TriangleMesh tetrahedra{{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
                          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  for (std::size_t i = 0; i < 4; ++i) {
    tetrahedra.positions.push_back(tetrahedra.positions[i] + Vec3f{5, 0, 0});
    Triangle t = tetrahedra.triangles[i];
    for (auto& vertex : t) vertex += 4;
    tetrahedra.triangles.push_back(t);
  }
  const auto springs = mesh_springs(tetrahedra, BoundaryWeights::Area);
  CHECK(springs.size() == 12);
  for (const auto& [pair, s] : by_pair(springs)) {
    CHECK(s.kind == SpringKind::Structural);
    CHECK(s.weight == 1.0);
    CHECK((pair.first < 4) == (pair.second < 4));
  }
  // Two triangles on the same three vertices: nothing lies across their edges.
  CHECK(mesh_springs({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, BoundaryWeights::Area)
            .size() == 3);
}

TEST_CASE("springs of random meshes are sorted, unique, and include every edge") {
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const auto springs = mesh_springs(mesh, BoundaryWeights::Area);
    CHECK(std::is_sorted(springs.begin(), springs.end(), [](const MeshSpring& a, const MeshSpring& b) {
      return Pair{a.node_a, a.node_b} < Pair{b.node_a, b.node_b};
    }));
    const auto map = by_pair(springs);
    for (const Triangle& t : mesh.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]); a != b) CHECK(map.contains({a, b}));
  }
}
