#include "player/air.hpp"

#include <doctest/doctest.h>

using namespace weft;
using namespace weft::window;

TEST_CASE("a vector takes a strength and keeps its direction; wind keeps its climb") {
  const Vec3d half = scaled({0, -10, 0}, 5);
  CHECK(half.y == -5);
  CHECK(scaled({0, 0, 0}, 3).y == -3);
  const Vec3d wind = blowing(10, 90, {0, 0, 2});
  CHECK(wind.x == doctest::Approx(10));
  CHECK(wind.z == doctest::Approx(0));
  CHECK(heading_of(wind) == 90);
  CHECK(heading_of({0, 5, 0}) == 0);
  const Vec3d climbing = blowing(10, 0, {3, 4, 0});  // four fifths of it upwards
  CHECK(climbing.y == doctest::Approx(8));
  CHECK(climbing.z == doctest::Approx(6));
}
