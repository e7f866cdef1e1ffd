// Convex hulls: against closed forms, by what makes a body convex, and of hostile points.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>

#include "base/random.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/convex_hull.hpp"
#include "mesh/orientation.hpp"

using namespace weft;
using mesh::TriangleMesh;

namespace {

using Points = std::vector<Vec3f>;

TriangleMesh hull_of(const Points& points) {
  auto hull = mesh::convex_hull(points);
  if (!hull) FAIL(hull.error().message);
  return *hull;
}

std::string no_hull(const Points& points) {
  const auto hull = mesh::convex_hull(points);
  REQUIRE_FALSE(hull);
  return hull.error().message;
}

/// What every hull is: closed, of Euler's formula, convex to the bit, with all points inside, its corners among them.
void check_hull(const Points& points, const TriangleMesh& hull) {
  const std::size_t corners = hull.positions.size(), faces = hull.triangles.size();
  const std::size_t edges = mesh::mesh_edges(hull.triangles).size();
  CHECK(corners + faces == edges + 2);
  std::set<std::array<std::uint32_t, 2>> ways;
  for (const mesh::Triangle& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) ways.insert({t[k], t[(k + 1) % 3]});
  CHECK(ways.size() == 3 * faces);  // none twice, and each both ways:
  for (const auto& [a, b] : ways) REQUIRE(ways.count({b, a}) == 1);
  CHECK(mesh::signed_volume(hull) > 0);
  const double tolerance = mesh::hull_tolerance(points);
  std::size_t beyond = 0, bent = 0;
  for (const mesh::Triangle& t : hull.triangles) {
    const Vec3d a = hull.positions[t[0]].to<double>(), b = hull.positions[t[1]].to<double>(),
                c = hull.positions[t[2]].to<double>();
    const Vec3d normal = cross(b - a, c - a);
    REQUIRE(length(normal) > 0);
    for (const Vec3f& p : hull.positions) bent += mesh::orientation(a, b, c, p.to<double>()) > 0 ? 1 : 0;
    for (const Vec3f& p : points)
      beyond += dot(normal, p.to<double>() - a) / length(normal) > tolerance * (1 + 1e-9) ? 1 : 0;
  }
  CHECK(bent == 0);
  CHECK(beyond == 0);
  for (const Vec3f& p : hull.positions) REQUIRE(std::find(points.begin(), points.end(), p) != points.end());
}

Points scaled(Points points, const Vec3d& size, const Vec3d& shift = {}) {
  for (Vec3f& p : points) {
    const Vec3d q = p.to<double>();
    p = Vec3d{q.x * size.x + shift.x, q.y * size.y + shift.y, q.z * size.z + shift.z}.to<float>();
  }
  return points;
}

Points ball(std::size_t count, std::uint64_t seed, bool surface) {
  Random random(seed);
  Points points;
  while (points.size() < count) {
    const Vec3d p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double size = length(p);
    if (size > 1 || size < 0.01) continue;
    points.push_back((surface ? p / size : p).to<float>());
  }
  return points;
}

Points lattice(int n) {
  Points points;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z)
        points.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  return points;
}

}  // namespace

TEST_CASE("a hull of random points is closed and convex, and has all of them inside") {
  std::uint64_t seed = 0;
  for (const std::size_t count : {4U, 5U, 8U, 20U, 100U, 500U, 2000U})
    for (const bool surface : {false, true})
      for (const Vec3d& size : {Vec3d{1, 1, 1}, Vec3d{1000, 1, 1}, Vec3d{1, 0.001, 1},
                                Vec3d{1e-6, 1e-6, 1e-6}, Vec3d{1e12, 1e12, 1e12}})
        for (const Vec3d& shift : {Vec3d{}, Vec3d{3, -40, 500}}) {
          CAPTURE(count);
          CAPTURE(size.x);
          CAPTURE(size.y);
          CAPTURE(shift.z);
          const Points points = scaled(ball(count, ++seed, surface), size, shift.z > 0 ? shift : Vec3d{});
          const auto hull = mesh::convex_hull(points);
          if (shift.z > 0 && size.x < 1e-3) {  // all within the rounding of a place 500 m away
            REQUIRE_FALSE(hull);
            continue;
          }
          REQUIRE(hull);
          check_hull(points, *hull);
        }
}

TEST_CASE("points on a sphere are all corners, and their hull's volume comes to the ball's") {
  const Points points = ball(5000, 7, true);
  const TriangleMesh hull = hull_of(points);
  CHECK(hull.positions.size() == points.size());
  CHECK(hull.triangles.size() == 2 * points.size() - 4);
  const double volume = mesh::signed_volume(hull), exact = 4.0 / 3.0 * 3.14159265358979;
  CHECK(volume < exact);
  CHECK(volume > 0.995 * exact);
}

TEST_CASE("of a lattice only the eight corners remain, of any number of points in faces and on edges") {
  for (const int n : {1, 2, 5, 12}) {
    const Points points = lattice(n);
    const TriangleMesh hull = hull_of(points);
    check_hull(points, hull);
    CHECK(hull.positions.size() == 8);
    CHECK(hull.triangles.size() == 12);
    CHECK(mesh::signed_volume(hull) == doctest::Approx(n * n * n).epsilon(1e-14));
  }
}

TEST_CASE("a lattice that was turned keeps eight corners, though rounding moves its points off the faces") {
  Random random(3);
  for (int turn = 0; turn < 20; ++turn) {
    std::array<double, 4> q{};
    for (double& part : q) part = random.uniform(-1, 1);
    TriangleMesh placed{lattice(8), {}};
    placed = mesh::transformed(placed, 0.125, q, {random.uniform(-5, 5), 1, 2});
    const TriangleMesh hull = hull_of(placed.positions);
    check_hull(placed.positions, hull);
    CHECK(hull.positions.size() == 8);
    CHECK(mesh::signed_volume(hull) == doctest::Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("volumes of known bodies are exact") {
  const Points tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(mesh::signed_volume(hull_of(tetrahedron)) == doctest::Approx(1.0 / 6).epsilon(1e-15));
  const Points octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  CHECK(mesh::signed_volume(hull_of(octahedron)) == doctest::Approx(4.0 / 3).epsilon(1e-15));
  CHECK(hull_of(octahedron).positions.size() == 6);
  for (const int n : {3, 5, 64, 1000}) {  // a prism over a regular polygon
    Points prism;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * 3.14159265358979 * k / n;
      for (const float y : {-1.0F, 1.0F})
        prism.push_back({static_cast<float>(std::cos(angle)), y, static_cast<float>(std::sin(angle))});
    }
    const TriangleMesh hull = hull_of(prism);
    check_hull(prism, hull);
    CHECK(hull.positions.size() == prism.size());
    CHECK(mesh::signed_volume(hull) == doctest::Approx(n * std::sin(2 * 3.14159265358979 / n)).epsilon(1e-6));
  }
}

TEST_CASE("duplicates and the order of points change no corner") {
  Points points = ball(300, 11, false);
  const TriangleMesh hull = hull_of(points);
  std::set<std::array<float, 3>> corners;
  for (const Vec3f& p : hull.positions) corners.insert({p.x, p.y, p.z});
  points.insert(points.end(), points.begin(), points.end());
  Random random(5);
  for (int turn = 0; turn < 5; ++turn) {
    for (std::size_t k = points.size(); k > 1; --k)
      std::swap(points[k - 1], points[random.below(static_cast<std::uint32_t>(k))]);
    const TriangleMesh other = hull_of(points);
    check_hull(points, other);
    std::set<std::array<float, 3>> others;
    for (const Vec3f& p : other.positions) others.insert({p.x, p.y, p.z});
    CHECK(others == corners);
  }
}

TEST_CASE("points without a volume, or that are not finite, are refused") {
  CHECK(no_hull({}).find("The 0 points lie in a plane") == 0);
  CHECK(no_hull({{1, 2, 3}}).find("The 1 points lie in a plane") == 0);
  CHECK(no_hull(Points(10, {1, 2, 3})).find("a convex hull needs points on all sides of a volume") !=
        std::string::npos);
  CHECK(no_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {0.1F, 0.1F, 0.1F}}).find("plane") !=
        std::string::npos);
  Points flat = lattice(4);
  for (Vec3f& p : flat) p.y = 0.5F;
  CHECK(no_hull(flat).find("The 125 points lie in a plane") == 0);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Points points = lattice(1);
    points[3].z = bad;
    CHECK(no_hull(points).find("Point 3 has the coordinate") == 0);
  }
  // Planes and lines that only rounding leaves.
  Random random(9);
  for (int turn = 0; turn < 200; ++turn) {
    const auto draw = [&] {
      return Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const Vec3d u = draw(), v = turn % 2 == 0 ? draw() : Vec3d{}, at = 3 * draw();
    Points points;
    for (int k = 0; k < 50; ++k) {
      const double s = random.uniform(-1, 1), t = random.uniform(-1, 1);
      points.push_back((at + s * u + t * v).to<float>());
    }
    CHECK(no_hull(points).find("lie in a plane") != std::string::npos);
  }
}

TEST_CASE("the largest and the smallest numbers of f32 have hulls, and too many corners are refused") {
  for (const double size : {3e38, 1e-30}) {
    const Points points = scaled(ball(50, 13, true), {size, size, size});
    const TriangleMesh hull = hull_of(points);
    CHECK(hull.positions.size() == 50);
    CHECK(hull.triangles.size() == 96);
  }
  const auto many = mesh::convex_hull(ball(70000, 17, true));
  REQUIRE_FALSE(many);
  CHECK(many.error().kind == ErrorKind::Limit);
  CHECK(many.error().message.find("corners, more than 65536.") != std::string::npos);
}
