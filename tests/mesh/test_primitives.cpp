#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "mesh/primitives.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

// Every directed edge once, and its opposite too: closed, and all triangles turn the same way.
bool is_closed_and_consistent(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
  return true;
}

}  // namespace

TEST_CASE("the sphere of 20 x 20 has 382 vertices and 760 triangles") {
  const TriangleMesh sphere = make_sphere(20, 20);
  CHECK(sphere.positions.size() == 382);
  CHECK(sphere.triangles.size() == 760);
}

TEST_CASE("spheres are round, closed and face outward") {
  for (const auto& [columns, rows] : {std::pair{3, 2}, {4, 3}, {20, 20}, {64, 31}}) {
    const TriangleMesh sphere = make_sphere(columns, rows);
    REQUIRE(check_mesh(sphere));
    CHECK(is_closed_and_consistent(sphere));
    for (const Vec3f& p : sphere.positions) CHECK(length(p) == doctest::Approx(1.0F).epsilon(1e-6).scale(0));
    for (const Triangle& t : sphere.triangles) {
      const Vec3f a = sphere.positions[t[0]], b = sphere.positions[t[1]], c = sphere.positions[t[2]];
      CHECK(dot(cross(b - a, c - a), a + b + c) > 0.0F);
    }
  }
  CHECK(signed_volume(make_sphere(200, 200)) == doctest::Approx(4.18879).epsilon(1e-3).scale(0));  // 4/3 π
}

TEST_CASE("a geodesic sphere is round, closed, faces outward, and has triangles of nearly one size") {
  for (const int cells : {1, 2, 3, 8, 17}) {
    CAPTURE(cells);
    const TriangleMesh sphere = make_geodesic_sphere(cells);
    REQUIRE(check_mesh(sphere));
    CHECK(sphere.positions.size() == static_cast<std::size_t>(10 * cells * cells + 2));
    CHECK(sphere.triangles.size() == static_cast<std::size_t>(20 * cells * cells));
    CHECK(is_closed_and_consistent(sphere));
    for (const Vec3f& p : sphere.positions) CHECK(length(p) == doctest::Approx(1.0F).epsilon(1e-6).scale(0));
    float least = 1e9F, most = 0;
    for (const Triangle& t : sphere.triangles) {
      const Vec3f a = sphere.positions[t[0]], b = sphere.positions[t[1]], c = sphere.positions[t[2]];
      const Vec3f normal = cross(b - a, c - a);
      CHECK(dot(normal, a + b + c) > 0.0F);
      least = std::min(least, length(normal));
      most = std::max(most, length(normal));
    }
    // A face's middle is 0.795 as far from the centre as its corners: areas of the sphere by those of the face go with
    // the inverse cube, 2.0.
    CHECK(most < 2.1F * least);
  }
  CHECK(signed_volume(make_geodesic_sphere(40)) == doctest::Approx(4.18879).epsilon(1e-3).scale(0));
}

TEST_CASE("a box has its size, and is closed and faces outward") {
  const TriangleMesh box = make_box({2, 3, 0.5});
  REQUIRE(check_mesh(box));
  CHECK(box.positions.size() == 8);
  CHECK(box.triangles.size() == 12);
  CHECK(bounds(box).low == Vec3f{-1, -1.5F, -0.25F});
  CHECK(bounds(box).high == Vec3f{1, 1.5F, 0.25F});
  CHECK(is_closed_and_consistent(box));
  for (const Triangle& t : box.triangles) {
    const Vec3f a = box.positions[t[0]], b = box.positions[t[1]], c = box.positions[t[2]];
    CHECK(dot(cross(b - a, c - a), a) > 0.0F);
  }
  CHECK(signed_volume(box) == doctest::Approx(3));
}

TEST_CASE("a capsule has its radius around its axis, and is closed and faces outward") {
  for (const auto& [columns, rows] : {std::pair{3, 1}, {7, 2}, {48, 12}}) {
    const TriangleMesh capsule = make_capsule(2, 0.5, columns, rows);
    REQUIRE(check_mesh(capsule));
    CHECK(capsule.positions.size() == static_cast<std::size_t>(2 * columns * rows + 2));
    CHECK(is_closed_and_consistent(capsule));
    CHECK(signed_volume(capsule) > 0);
    for (const Vec3f& p : capsule.positions) {
      const Vec3f on_axis{0, std::min(1.0F, std::max(-1.0F, p.y)), 0};
      CHECK(length(p - on_axis) == doctest::Approx(0.5F).epsilon(1e-6).scale(0));
    }
    TriangleMesh left = capsule;
    CHECK(drop_degenerate_triangles(left) == 0);
  }
  const double volume = 3.14159265 * (0.25 * 2 + 4.0 / 3 * 0.125);
  CHECK(signed_volume(make_capsule(2, 0.5, 200, 100)) == doctest::Approx(volume).epsilon(1e-3).scale(0));
}
