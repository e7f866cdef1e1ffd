// The pairs of whole frames: against brute force, and against the narrow phase that says where f32 may
// differ.
#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "contact/reference/pushes/contact_pairs.hpp"
#include "mesh/primitives.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

TEST_CASE("the tree finds the pairs of the unpruned loops, in their order") {
  Random random(3);
  for (const auto& [cloth_count, object_count, reach] :
       {std::tuple{300U, 1U, 0.3}, {200U, 5U, 0.3}, {300U, 777U, 0.05}, {40U, 2000U, 0.4}}) {
    const Soup cloth = random_soup(random, cloth_count, reach);
    const ObjectTriangles object(random_soup(random, object_count, 0.05).mesh());
    const std::vector<TrianglePair> pairs = object.pairs(cloth.triangles, cloth.positions);
    CHECK(pairs == object.pairs_by_brute_force(cloth.triangles, cloth.positions));
    CHECK((object_count < 700 || pairs.size() > 10));
  }
  const ObjectTriangles none(mesh::TriangleMesh{});
  const Soup cloth = random_soup(random, 3, 0.1);
  CHECK(none.pairs(cloth.triangles, cloth.positions).empty());
}

TEST_CASE(
    "a pair crosses wherever the narrow phase is sure that it hits, and nowhere that it is sure to miss") {
  Random random(5);
  int hits = 0, misses = 0;
  for (int i = 0; i < 200000; ++i) {
    // Every second pair on a coarse lattice, where corners, edges and planes coincide.
    const auto point = [&] {
      if (i % 2 == 0) return random_point(random, 1);
      const auto step = [&] { return static_cast<double>(random.below(5)); };
      return Vec3d{step(), step(), step()};
    };
    const TrianglePoints a{point(), point(), point()}, b{point(), point(), point()};
    const Verdict verdict = triangle_pair(a, b);
    if (verdict == Verdict::Ambiguous) continue;
    (verdict == Verdict::Hit ? hits : misses)++;
    if (triangles_cross(a, b) != (verdict == Verdict::Hit)) FAIL_CHECK("pair ", i, " differs");
  }
  CHECK(hits > 20000);
  CHECK(misses > 20000);
}

TEST_CASE("cloth that is not finite touches nothing") {
  const ObjectTriangles ball(mesh::make_sphere(12, 6));
  const std::vector<mesh::Triangle> cloth = {{0, 1, 2}};
  std::vector<Vec3d> positions = {{-2, 0.1, -2}, {2, 0.1, -2}, {0, 0.1, 2}};
  CHECK(!ball.pairs(cloth, positions).empty());
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    positions[0].y = bad;
    CHECK(ball.pairs(cloth, positions).empty());
  }
}
