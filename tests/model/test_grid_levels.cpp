#include <doctest/doctest.h>

#include "method/method.hpp"
#include "method/multigrid/grid_levels.hpp"
#include "scene/load.hpp"

using namespace weft;

TEST_CASE("a side of N nodes becomes one of N / 2 + 1, until it has five or fewer") {
  std::vector<std::uint32_t> sides;
  for (const GridLevel& level : grid_levels(800, 800)) sides.push_back(level.nx);
  CHECK(sides == std::vector<std::uint32_t>{800, 401, 201, 101, 51, 26, 14, 8, 5});
  CHECK(grid_levels(5, 2).size() == 1);
  const auto narrow = grid_levels(65, 4);  // the short side stays
  REQUIRE(narrow.size() == 5);
  CHECK(narrow.back().nx == 5);
  CHECK(narrow.back().ny == 4);
}

TEST_CASE("an even side leaves a short last interval, on all coarser levels too") {
  const auto levels = grid_levels(34, 33);  // 34, 18, 10, 6, 4 and 33, 17, 9, 5
  CHECK(levels[0].even_i);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    CHECK_FALSE(levels[l].even_i);
    CHECK(levels[l].even_j);
  }
}

TEST_CASE("resistance to bending halves from level to level, and by the side where one stays") {
  const auto square = grid_levels(17, 17);
  CHECK(square[1].bending_i == 0.5);
  CHECK(square[2].bending_j == 0.25);
  const auto narrow = grid_levels(17, 3);
  CHECK(narrow[1].bending_i == 0.25);
  CHECK(narrow[1].bending_j == 2);
}

TEST_CASE("auto takes multigrid for large grids, and never for meshes") {
  const auto choice = [](const std::string& kind, const std::string& cloth) {
    const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": ")" + kind +
                                              R"("}, "cloths": [{"density": 1, )" + cloth + "}]}",
                                          "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    mesh::TriangleMesh mesh;
    if (!scene->cloths[0].grid) {
      mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      mesh.triangles = {{0, 1, 2}};
    }
    const auto model = build_model(*scene, {mesh});
    REQUIRE_MESSAGE(model, model.error().message);
    return choose_method(*scene, *model);
  };
  using Kind = scene::SolverKind;
  CHECK(choice("auto", R"("grid": [316, 316], "size": [1, 1])").method->kind == Kind::MassSpring);  // 99,856
  const MethodChoice large = choice("auto", R"("grid": [317, 316], "size": [1, 1])");               // 100,172
  CHECK(large.method->kind == Kind::Multigrid);
  CHECK(large.reason == "100172 nodes are not fewer than the 100000, from which on multigrid is cheaper");
  CHECK(choice("auto", R"("mesh": "a.obj")").method->kind == Kind::MassSpring);
  CHECK(choice("multigrid", R"("grid": [4, 4], "size": [1, 1])").method->kind == Kind::Multigrid);
  CHECK(choice("mass_spring", R"("grid": [4, 4], "size": [1, 1])").reason.empty());
}
