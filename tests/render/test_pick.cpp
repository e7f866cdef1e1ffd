#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "render/pick.hpp"

using namespace weft;
using namespace weft::render;

namespace {

Vec3d random_point(Random& random, double reach = 1) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// From an origin outside of the unit box to a place in it.
Ray random_ray(Random& random) {
  const Vec3d origin = random_point(random) + Vec3d{random.below(2) == 0 ? -3.0 : 3.0, 0, 0};
  const Vec3d direction = random_point(random) - origin;
  return {origin, direction / length(direction)};
}

struct Soup {
  std::vector<Vec4f> positions;
  std::vector<mesh::Triangle> triangles;
  Vec3d corner(std::uint32_t t, std::size_t i) const { return positions[triangles[t][i]].xyz().to<double>(); }
};

Soup random_soup(Random& random, std::uint32_t count) {
  Soup soup;
  for (std::uint32_t i = 0; i < 3 * count; ++i)
    soup.positions.push_back(Vec4f::from(random_point(random).to<float>(), 1));
  for (std::uint32_t i = 0; i < count; ++i) soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return soup;
}

/// Where the ray meets the triangle's plane, and how far inside of all sides that is, as a share of their
/// heights; by another way than pick_node's.
struct PlaneHit {
  double distance = 0, inside = 0;
};
PlaneHit plane_hit(const Ray& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d n = cross(b - a, c - a);
  const double distance = dot(n, a - ray.origin) / dot(n, ray.direction);
  const Vec3d p = ray.origin + distance * ray.direction;
  const double of_a = dot(n, cross(c - b, p - b)) / dot(n, n), of_b = dot(n, cross(a - c, p - c)) / dot(n, n);
  return {distance, std::min({of_a, of_b, 1 - of_a - of_b})};
}

const Soup kSquare{{{-1, -1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}, {-1, 1, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};

std::optional<PickedNode> pick(const Soup& soup, const Vec3d& origin, const Vec3d& direction) {
  return pick_node({origin, direction}, soup.positions, soup.triangles);
}

}  // namespace

TEST_CASE("the ray through a point's place in the picture passes through the point, and back") {
  Random random(1);
  for (int round = 0; round < 1000; ++round) {
    const Camera camera{random_point(random, 5), random_point(random, 5), random.uniform(15, 80)};
    const double aspect = random.uniform(0.3, 3), x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Ray ray = pick_ray(camera, aspect, x, y);
    CHECK(length(ray.direction) == doctest::Approx(1).epsilon(1e-15).scale(0));
    const double far = random.uniform(0.1, 100);
    const Projected place = project(camera, aspect, ray.origin + far * ray.direction);
    CHECK(std::abs(place.x - x) < 1e-12);
    CHECK(std::abs(place.y - y) < 1e-12);
    CHECK(place.depth > 0);
    CHECK(place.depth <= far * (1 + 1e-12));
    CHECK(project(camera, aspect, ray.origin - far * ray.direction).depth < 0);
  }
}

TEST_CASE("a point's place is where the picture has it") {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    const Camera camera{random_point(random, 5), random_point(random, 5), random.uniform(15, 80)};
    const Vec3d point =
        pick_ray(camera, 1.5, random.uniform(-1, 1), random.uniform(-1, 1)).direction + camera.eye;
    const auto clip = view_projection(camera, 1.5, 0.1, 100).apply(point);
    const Projected place = project(camera, 1.5, point);
    CHECK(std::abs(place.x - clip[0] / clip[3]) < 1e-12);
    CHECK(std::abs(place.y - clip[1] / clip[3]) < 1e-12);
    CHECK(std::abs(place.depth - clip[3]) < 1e-12);
  }
}

TEST_CASE(
    "the picked triangle is the first of those that the ray passes through, its node the nearest corner") {
  Random random(3);
  int hits = 0;
  for (int round = 0; round < 2000; ++round) {
    const Soup soup = random_soup(random, 1 + static_cast<std::uint32_t>(random.below(12)));
    const Ray ray = random_ray(random);
    std::optional<std::uint32_t> first;
    double nearest = 0;
    bool doubtful = false;  // on a side within rounding
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
      const PlaneHit at = plane_hit(ray, soup.corner(t, 0), soup.corner(t, 1), soup.corner(t, 2));
      doubtful = doubtful || std::abs(at.inside) < 1e-9;
      if (at.inside < 0 || at.distance < 0 || (first && at.distance >= nearest)) continue;
      first = t;
      nearest = at.distance;
    }
    if (doubtful) continue;
    CAPTURE(round);
    const auto picked = pick_node(ray, soup.positions, soup.triangles);
    REQUIRE(picked.has_value() == first.has_value());
    if (!picked) continue;
    ++hits;
    CHECK(picked->triangle == *first);
    CHECK(picked->distance == doctest::Approx(nearest).epsilon(1e-9).scale(0));
    CHECK(length(picked->point - (ray.origin + nearest * ray.direction)) < 1e-9);
    const auto reach = [&](std::uint32_t node) {
      return length(soup.positions[node].xyz().to<double>() - picked->point);
    };
    const mesh::Triangle& corners = soup.triangles[picked->triangle];
    CHECK(std::find(corners.begin(), corners.end(), picked->node) != corners.end());
    for (const std::uint32_t corner : corners) CHECK(reach(picked->node) <= reach(corner));
  }
  CHECK(hits > 200);
}

TEST_CASE("a square is picked from both sides, and not beside it, behind the ray or in its own plane") {
  const auto front = pick(kSquare, {0.7, -0.6, 5}, {0, 0, -1}),
             back = pick(kSquare, {-0.9, 0.6, -5}, {0, 0, 1});
  REQUIRE(front);
  CHECK(front->node == 1);
  CHECK(front->distance == doctest::Approx(5));
  CHECK(length(front->point - Vec3d{0.7, -0.6, 0}) < 1e-15);
  REQUIRE(back);
  CHECK(back->node == 3);
  CHECK_FALSE(pick(kSquare, {1.001, 0, 5}, {0, 0, -1}));   // beside
  CHECK_FALSE(pick(kSquare, {0, 0.1, 5}, {0, 0, 1}));      // behind
  CHECK_FALSE(pick(kSquare, {-5, 0.1, 0}, {1, 0, 0}));     // along the plane
  CHECK_FALSE(pick(kSquare, {-5, 0.1, 1e-9}, {1, 0, 0}));  // just above it
  CHECK_FALSE(pick({}, {0, 0, 5}, {0, 0, -1}));
}

TEST_CASE("no ray slips between two triangles that share a side") {
  Random random(4);
  Soup soup = kSquare;
  for (int round = 0; round < 5000; ++round) {
    for (Vec4f& position : soup.positions) position.z = static_cast<float>(random.uniform(-0.2, 0.2));
    const Vec3d origin = random_point(random) + Vec3d{0, 0, 4};
    const Vec3d from = soup.corner(0, 0), to = soup.corner(0, 2);  // the diagonal
    const Vec3d direction = from + random.uniform(0.01, 0.99) * (to - from) - origin;
    CAPTURE(round);
    CHECK(pick(soup, origin, direction / length(direction)));
  }
}

TEST_CASE("a ray at any inner node of a sheet meets it there") {
  Random random(5);
  Soup sheet;
  constexpr std::uint32_t kSide = 24;
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i)
      sheet.positions.push_back(
          Vec4f::from(Vec3d{0.1 * i, -0.1 * j, random.uniform(0, 0.02)}.to<float>(), 1));
  for (std::uint32_t j = 0; j + 1 < kSide; ++j)
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t at = j * kSide + i;
      sheet.triangles.push_back({at, at + kSide, at + 1});
      sheet.triangles.push_back({at + 1, at + kSide, at + kSide + 1});
    }
  const Camera camera{{2.9, 0.3, 4.1}, {1.1, -1.2, 0}, 40};
  for (std::uint32_t j = 1; j + 1 < kSide; ++j)
    for (std::uint32_t i = 1; i + 1 < kSide; ++i) {
      const std::uint32_t node = j * kSide + i;
      CAPTURE(node);
      const Projected place = project(camera, 1.5, sheet.positions[node].xyz().to<double>());
      const auto picked =
          pick_node(pick_ray(camera, 1.5, place.x, place.y), sheet.positions, sheet.triangles);
      REQUIRE(picked);
      CHECK(picked->node == node);
    }
}

TEST_CASE(
    "within an area are the points of rays through it before the eye, whatever the order of its corners") {
  Random random(7);
  for (int round = 0; round < 50; ++round) {
    const Camera camera{random_point(random, 5), random_point(random, 5), random.uniform(15, 80)};
    const double x = random.uniform(-1, 0.4), y = random.uniform(-1, 0.4);
    const PickArea area{x + 0.5, y, x, y + 0.5};
    std::vector<Vec4f> positions;
    std::vector<std::uint32_t> inside;
    for (std::uint32_t node = 0; node < 200; ++node) {
      const double px = random.uniform(-1, 1), py = random.uniform(-1, 1);
      const bool before = node % 3 != 0;
      const Ray ray = pick_ray(camera, 1.3, px, py);
      const Vec3d point = ray.origin + (before ? 1 : -1) * random.uniform(1, 9) * ray.direction;
      positions.push_back(Vec4f::from(point.to<float>(), 1));
      const double edge =
          std::min({std::abs(px - x), std::abs(px - x - 0.5), std::abs(py - y), std::abs(py - y - 0.5)});
      if (edge < 1e-5)
        positions.back() = Vec4f::from(Vec3f{NAN, 0, 0}, 1);  // f32 may round it across
      else if (before && px > x && px < x + 0.5 && py > y && py < y + 0.5)
        inside.push_back(node);
    }
    CHECK(nodes_within(camera, 1.3, area, positions) == inside);
  }
}

TEST_CASE("a ray to a corner, and a corner that is not a number, are no trouble") {
  const auto corner = pick(kSquare, {-1, -1, 5}, {0, 0, -1});
  REQUIRE(corner);
  CHECK(corner->node == 0);
  Soup broken = kSquare;
  broken.positions[3].x = std::nanf("");
  CHECK(pick(broken, {0.5, -0.5, 5}, {0, 0, -1})->triangle == 0);
  CHECK_FALSE(pick(broken, {-0.5, 0.5, 5}, {0, 0, -1}));
}
