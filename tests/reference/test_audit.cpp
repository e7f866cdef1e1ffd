// The audit of contact: exact sides, crossings against brute force, depths and distances in closed form.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "contact/reference/proximity/closest.hpp"
#include "mesh/orientation.hpp"
#include "mesh/primitives.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

__extension__ using Wide = __int128;

struct Whole {
  std::int64_t x, y, z;
  Vec3d point() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};

int exact_side(const Whole& a, const Whole& b, const Whole& c, const Whole& p) {
  const Wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const Wide det = (p.x - a.x) * (uy * vz - uz * vy) + (p.y - a.y) * (uz * vx - ux * vz) +
                   (p.z - a.z) * (ux * vy - uy * vx);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

const Soup kPlate{{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}, {{0, 1, 2}}};

Soup needle(const Vec3d& from, const Vec3d& to, double width) {
  return {{from, to, from + Vec3d{width, 0, 0}}, {{0, 1, 2}}};
}

}  // namespace

TEST_CASE("sides of planes are exact where rounding would turn them") {
  Random random(21);
  int turned = 0, zero = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto whole = [&] {
      // Up to 2^36: determinants need 111 bits, double has 53.
      const auto one = [&] { return static_cast<std::int64_t>(random.uniform(-1, 1) * (1LL << 36)); };
      return Whole{one(), one(), one()};
    };
    const Whole a = whole(), b = whole(), c = whole();
    // In the plane of the others, or a unit beside it.
    Whole p{b.x + c.x - a.x, b.y + c.y - a.y, b.z + c.z - a.z};
    if (i % 4 > 0) p.y += i % 4 - 2;
    const int side = mesh::orientation(a.point(), b.point(), c.point(), p.point());
    if (side != exact_side(a, b, c, p)) FAIL_CHECK("point ", i);
    zero += side == 0;
    const Vec3d u = b.point() - a.point(), v = c.point() - a.point(), w = p.point() - a.point();
    const double rounded = dot(w, cross(u, v));
    turned += (rounded > 0) - (rounded < 0) != side;
  }
  CHECK(zero >= 10000);
  CHECK(turned > 2000);  // the plain formula fails here
}

TEST_CASE(
    "a needle through a coarse triangle crosses, and one that ends in it or passes its border touches") {
  const auto crosses = [](const Soup& other) { return crossings(kPlate, other).size(); };
  CHECK(crosses(needle({1, 1, 1}, {1, -1, 1}, 1e-3)) == 1);
  CHECK(crosses(needle({1, 1e-300, 1}, {1, -1e-300, 1}, 0)) == 1);
  CHECK(crosses(needle({1, 1, 1}, {1, 0, 1}, 1e-3)) == 0);   // ends in the plane
  CHECK(crosses(needle({1, 1, 0}, {1, -1, 0}, 0)) == 0);     // through the border
  CHECK(crosses(needle({0, 1, 0}, {0, -1, 0}, 0)) == 0);     // through a corner
  CHECK(crosses(needle({1, 0, 1}, {2, 0, 1}, 1e-3)) == 0);   // in the plane
  CHECK(crosses(needle({3, 1, 3}, {3, -1, 3}, 1e-3)) == 0);  // past it
  CHECK(crosses(kPlate) == 0);                               // a duplicate
  Soup low = needle({1, 1, 1}, {1, -1, 1}, 1e-3);
  low.positions[1].y = std::nan("");
  CHECK(crosses(low) == 0);
  // Edge on edge: a saddle whose edges pass each other at 1e-12 above, then below.
  const auto saddle = [&](double height) {
    return Soup{{{1, height, -1}, {1, height, 1}, {1, 5, 0}}, {{0, 1, 2}}};
  };
  CHECK(crosses(saddle(1e-12)) == 0);
  CHECK(crosses(saddle(-1e-12)) == 1);
}

TEST_CASE("the audit's crossings are those of the unpruned loops") {
  Random random(22);
  for (const auto& [cloth_count, object_count, reach] :
       {std::tuple{200U, 1U, 0.3}, {150U, 5U, 0.3}, {300U, 700U, 0.08}, {60U, 60U, 0.4}}) {
    const Soup cloth = random_soup(random, cloth_count, reach);
    const Soup object = random_soup(random, object_count, reach);
    const std::vector<Crossing> with = crossings(cloth, object), self = self_crossings(cloth);
    CHECK(with == crossings_by_brute_force(cloth, object));
    CHECK(self == self_crossings_by_brute_force(cloth));
    CHECK(self.size() > 10);
    CHECK((object_count < 10 || with.size() > 20));
  }
  CHECK(crossings(kPlate, Soup{}).empty());
}

TEST_CASE("neighbours do not cross at what they share, but a fold through a neighbour does") {
  // Two triangles with one common vertex: apart, then the second's far edge through the first.
  Soup fan{{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}, {1, 1, 1}, {3, 1, 3}}, {{0, 1, 2}, {0, 3, 4}}};
  CHECK(self_crossings(fan).empty());
  fan.positions[4] = {1, -1, 1.5};
  CHECK(self_crossings(fan) == std::vector<Crossing>{{0, 1}});
  // With a common edge there is nothing left to cross with.
  const Soup hinge{{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}, {1, 1e-9, 3.9}}, {{0, 1, 2}, {1, 0, 3}}};
  CHECK(self_crossings(hinge).empty());
}

TEST_CASE("vertices inside are counted, and the deepest is as deep as the surface is far") {
  mesh::TriangleMesh box;  // from -1 to 1
  for (int i = 0; i < 8; ++i)
    box.positions.push_back({i & 1 ? 1.0F : -1.0F, i & 2 ? 1.0F : -1.0F, i & 4 ? 1.0F : -1.0F});
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const std::vector<Vec3d> points = {
      {0.9, 0.5, 0}, {0, 0.25, 0.5}, {1.001, 0, 0}, {0, 3, 0}, {-0.5, -0.5, 0.95}};
  CHECK(inside_mesh(points, box).count == 3);
  CHECK(inside_mesh(points, box).deepest == doctest::Approx(0.5));
  CHECK(inside_mesh(points, mesh::TriangleMesh{}).count == 0);
  CHECK(inside_capsule(points, {0, 0, 0}, {0, 0, 0}, 1).count == 1);  // a sphere
  CHECK(inside_capsule(points, {0, 0, 0}, {0, 0, 0}, 1).deepest == doctest::Approx(1 - std::sqrt(0.3125)));
  CHECK(inside_capsule(points, {0, 0.5, 0}, {0, 9, 0}, 1).count == 3);
  CHECK(inside_capsule(points, {0, 0.5, 0}, {0, 9, 0}, 1).deepest == 1);
  CHECK(below_plane(points, {{0, 0.3, 0}, {0, 1, 0}}).count == 3);
  CHECK(below_plane(points, {{0, 0.3, 0}, {0, 1, 0}}).deepest == doctest::Approx(0.8));
}

TEST_CASE("the least distances are those of all pairs of features") {
  Random random(23);
  for (int round = 0; round < 6; ++round) {
    // Far enough apart that the least is seldom zero: small triangles.
    const Soup cloth = random_soup(random, 40, 0.03), object = random_soup(random, 30, 0.03);
    const auto least_of = [](const Soup& a, const Soup& b, bool one) {
      double least = std::numeric_limits<double>::infinity();
      const auto shares = [&](std::uint32_t v, const mesh::Triangle& t) {
        return one && (t[0] == v || t[1] == v || t[2] == v);
      };
      for (const auto& [from, onto] : {std::pair{&a, &b}, {&b, &a}})
        for (std::uint32_t v = 0; v < from->positions.size(); ++v)
          for (const mesh::Triangle& t : onto->triangles)
            if (!shares(v, t))
              least = std::min(least, closest_on_triangle(from->positions[v], onto->positions[t[0]],
                                                          onto->positions[t[1]], onto->positions[t[2]])
                                          .distance);
      for (const mesh::Triangle& s : a.triangles)
        for (const mesh::Triangle& t : b.triangles)
          for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) {
              const std::uint32_t p = s[j], q = s[(j + 1) % 3], u = t[k], v = t[(k + 1) % 3];
              if (one && (p == u || p == v || q == u || q == v)) continue;
              least = std::min(
                  least,
                  closest_segments(a.positions[p], a.positions[q], b.positions[u], b.positions[v]).distance);
            }
      return least;
    };
    CHECK(std::abs(least_distance(cloth, object) - least_of(cloth, object, false)) < 1e-15);
    CHECK(std::abs(least_self_distance(cloth) - least_of(cloth, cloth, true)) < 1e-15);
    CHECK(least_distance(cloth, object) > 0);
  }
  CHECK(least_distance(kPlate, Soup{}) == std::numeric_limits<double>::infinity());
  CHECK(least_distance(kPlate, needle({1, 2, 1}, {1, 7, 1}, 1e-3)) == 2);
  const Soup coplanar{{{5, 0, 0}, {9, 0, 0}, {5, 0, 4}}, {{0, 1, 2}}};
  CHECK(least_distance(kPlate, coplanar) == 1);
}
