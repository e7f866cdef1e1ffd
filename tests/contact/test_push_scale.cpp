#include <doctest/doctest.h>

#include <cmath>

#include "contact/pushes/push_scale.hpp"
#include "mesh/grid.hpp"

using namespace weft;
using namespace weft::contact;

TEST_CASE("the scale is the largest power of two for which the greatest sum stays below 2^31") {
  for (const double longest : {1e-6, 0.005, 0.063, 1.0, 1234.5})
    for (const std::uint64_t objects : {1ULL, 760ULL, 52000ULL, 2800000ULL}) {
      const PushBound bound{8, objects, 2};
      const double pushes = 8.0 * static_cast<double>(objects) + 2;
      const double scale = push_scale(bound, longest);
      CHECK(std::exp2(std::round(std::log2(scale))) == scale);
      CHECK(pushes * (longest * scale + 0.5) < 2147483648.0);
      CHECK(pushes * (2 * longest * scale * (1 + 1e-6) + 1) >= 2147483648.0);
    }
}

TEST_CASE("without colliders or pushes the scale is one, and extreme sizes stay numbers of f32") {
  CHECK(push_scale({8, 0, 0}, 1) == 1);
  CHECK(push_scale({8, 100, 0}, 0) == 1);
  CHECK(push_scale({8, 10, 2, 5}, 0.1) == push_scale({8, 15, 2}, 0.1));  // a convex body is as one triangle
  CHECK(push_scale({1, 1, 0}, 1e-300) == std::ldexp(1.0F, 126));
  CHECK(push_scale({1, 1, 0}, 1e300) == std::ldexp(1.0F, -126));
}

TEST_CASE("inside a sheet at most eight triangles share a vertex") {
  Model model;
  const mesh::Grid grid{5, 5, 2, 1};
  model.rest_position.resize(mesh::node_count(grid));
  model.triangles = mesh::grid_triangles(grid);
  CHECK(triangles_at_vertex(model) == 8);
  CHECK(triangles_at_vertex({}) == 0);
}
