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
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const GridLevel& level = levels[l];
    CHECK(level.interval_i == 1U << l);
    // The nodes of all levels span the same side.
    CHECK((level.nx - 2) * level.interval_i + level.last_i == 33);
    CHECK(level.last_i == 1);
    CHECK(level.last_j == level.interval_j);
  }
  const auto odd = grid_levels(23, 23);  // 23, 12, 7, 4: the even side is a coarse one
  CHECK(odd[1].last_i == 2);
  CHECK(odd[2].last_i == 2);
  CHECK(odd[2].interval_i == 4);
  CHECK(odd[3].last_i == 6);
  CHECK(odd[3].interval_i == 8);
}

TEST_CASE("resistance to bending halves from level to level, and by the side where one stays") {
  const auto square = grid_levels(17, 17);
  CHECK(square[1].bending_i == 0.5);
  CHECK(square[2].bending_j == 0.25);
  const auto narrow = grid_levels(17, 3);
  CHECK(narrow[1].bending_i == 0.25);
  CHECK(narrow[1].bending_j == 2);
}
