#include <doctest/doctest.h>

#include <cmath>

#include "contact/rules/max_push.hpp"

using namespace weft;

TEST_CASE("a push is at most the thickness and two of the longest rest edges") {
  const mesh::Grid grid{5, 5, 2, 1};  // edges of 0.5 and 0.25 m; the diagonal is the longest
  Model model;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const mesh::RestPoint at = mesh::rest_point(grid, i, j);
      model.rest_position.push_back({at.x, at.y, 0});
    }
  model.triangles = mesh::grid_triangles(grid);
  CHECK(max_push(model, 0.005) == doctest::Approx(0.005 + 2 * std::hypot(0.5, 0.25)).epsilon(1e-12).scale(0));
}
