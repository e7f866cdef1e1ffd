// Closest points: certificates of optimality, sampling, and the shapes that break formulas.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "contact/reference/proximity/closest.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr double kScales[] = {1e-4, 1, 1e4};

Vec3d random_point(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Vec3d point_of(const ClosestOnTriangle& found, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return found.weights[0] * a + found.weights[1] * b + found.weights[2] * c;
}

/// The result is a point of the triangle, its offset and distance are those of that point, and no corner is
/// further along the offset: the plane through the point, square to the offset, has the triangle on its far
/// side, so that no point of it is nearer.
bool proven(const ClosestOnTriangle& found, const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c,
            double tolerance) {
  const Vec3d q = point_of(found, a, b, c);
  double sum = 0;
  for (const double weight : found.weights) {
    if (!(weight >= 0)) return false;
    sum += weight;
  }
  if (std::abs(sum - 1) > 1e-14 || length(p - q - found.offset) > tolerance) return false;
  if (std::abs(length(found.offset) - found.distance) > tolerance) return false;
  for (const Vec3d& corner : {a, b, c})
    if (dot(found.offset, corner - q) > tolerance * (found.distance + tolerance)) return false;
  return true;
}

bool proven(const ClosestSegments& found, const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1,
            double tolerance) {
  const Vec3d p = a0 + found.s * (a1 - a0), q = b0 + found.t * (b1 - b0);
  if (!(found.s >= 0 && found.s <= 1 && found.t >= 0 && found.t <= 1)) return false;
  if (length(p - q - found.offset) > tolerance) return false;
  if (std::abs(length(found.offset) - found.distance) > tolerance) return false;
  const double most = tolerance * (found.distance + tolerance);
  for (const Vec3d& end : {a0, a1})
    if (dot(-found.offset, end - p) > most) return false;
  for (const Vec3d& end : {b0, b1})
    if (dot(found.offset, end - q) > most) return false;
  return true;
}

}  // namespace

TEST_CASE("no point of a triangle is nearer than the closest one, at three scales") {
  Random random(11);
  int inside = 0;
  for (const double scale : kScales)
    for (int i = 0; i < 20000; ++i) {
      const Vec3d a = random_point(random, scale), b = random_point(random, scale),
                  c = random_point(random, scale), p = random_point(random, scale);
      const ClosestOnTriangle found = closest_on_triangle(p, a, b, c);
      inside += found.weights[0] > 0 && found.weights[1] > 0 && found.weights[2] > 0;
      if (!proven(found, p, a, b, c, 1e-9 * scale)) FAIL_CHECK("triangle ", i, " at scale ", scale);
    }
  CHECK(inside > 3000);
}

TEST_CASE("the closest point of a triangle is no further than the best of a dense grid of samples") {
  Random random(12);
  constexpr int kSteps = 60;
  for (int i = 0; i < 60; ++i) {
    const Vec3d a = random_point(random, 1), b = random_point(random, 1), c = random_point(random, 1),
                p = random_point(random, 1);
    double least = 1e300;
    for (int u = 0; u <= kSteps; ++u)
      for (int v = 0; u + v <= kSteps; ++v)
        least = std::min(least,
                         length(p - (a + (b - a) * (u / double{kSteps}) + (c - a) * (v / double{kSteps}))));
    const double found = closest_on_triangle(p, a, b, c).distance;
    const double cell = (length(b - a) + length(c - a)) / kSteps;  // a sample lies within it
    CHECK(found <= least + 1e-12);
    CHECK(found >= least - cell);
  }
}

TEST_CASE("above each region of a triangle the closest point has its closed form") {
  const Vec3d a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  struct Case {
    Vec3d p;
    std::array<double, 3> weights;
    double distance;
  };
  for (const auto& [p, weights, distance] : {Case{{0.25, 0.25, 2}, {0.5, 0.25, 0.25}, 2},
                                             {{0.25, -3, 4}, {0.75, 0.25, 0}, 5},
                                             {{-3, 0.5, -4}, {0.5, 0, 0.5}, 5},
                                             {{1, 1, 0}, {0, 0.5, 0.5}, std::sqrt(0.5)},
                                             {{-3, -4, 0}, {1, 0, 0}, 5},
                                             {{4, -4, 0}, {0, 1, 0}, 5},
                                             {{0, 3, 0}, {0, 0, 1}, 2},
                                             {{0.5, 0.5, 0}, {0, 0.5, 0.5}, 0},  // on an edge
                                             {{1, 0, 0}, {0, 1, 0}, 0}}) {       // on a corner
    const ClosestOnTriangle found = closest_on_triangle(p, a, b, c);
    CHECK(found.distance == doctest::Approx(distance).epsilon(1e-15));
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(found.weights[k] - weights[k]) < 1e-15);
  }
}

TEST_CASE("triangles without area and slivers give the distance to their edges") {
  Random random(13);
  for (const double scale : kScales)
    for (int i = 0; i < 5000; ++i) {
      const Vec3d a = random_point(random, scale), b = random_point(random, scale),
                  p = random_point(random, scale);
      const double part = random.uniform(-0.5, 1.5);
      // One point; a point and a segment; three points of a line; slivers from 1e-16 to 1e-2 of their length.
      const Vec3d on_line = a + part * (b - a);
      const double width = scale * std::pow(10, -2 - i % 15);
      CHECK(closest_on_triangle(p, a, a, a).distance ==
            doctest::Approx(length(p - a)).epsilon(1e-14).scale(0));
      CHECK(closest_on_triangle(p, a, b, b).distance ==
            doctest::Approx(closest_on_segment(p, a, b).distance).epsilon(1e-14).scale(0));
      const Vec3d c = on_line + random_point(random, width);
      for (const Vec3d& third : {on_line, c}) {
        const ClosestOnTriangle found = closest_on_triangle(p, a, b, third);
        double edges = closest_on_segment(p, a, b).distance;
        edges = std::min(edges, closest_on_segment(p, a, third).distance);
        edges = std::min(edges, closest_on_segment(p, b, third).distance);
        const Vec3d q = point_of(found, a, b, third);
        CHECK(found.distance <= edges * (1 + 1e-14));
        CHECK(found.distance >= edges - 2 * width - 1e-12 * scale);
        CHECK(std::abs(length(p - q) - found.distance) < 1e-12 * scale);
      }
    }
}

TEST_CASE("a point on the edge of two triangles is at distance zero from both") {
  Random random(14);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d a = random_point(random, 1), b = random_point(random, 1), left = random_point(random, 1),
                right = random_point(random, 1);
    const double part = random.uniform(0, 1);
    const Vec3d p = a + part * (b - a);
    CHECK(closest_on_triangle(p, a, b, left).distance < 1e-15);
    CHECK(closest_on_triangle(p, b, a, right).distance < 1e-15);
    CHECK(closest_on_triangle(a, a, b, left).distance == 0);
  }
}

TEST_CASE("no points of two segments are nearer than the closest ones, at three scales") {
  Random random(15);
  int inside = 0;
  for (const double scale : kScales)
    for (int i = 0; i < 20000; ++i) {
      const Vec3d a0 = random_point(random, scale), a1 = random_point(random, scale),
                  b0 = random_point(random, scale), b1 = random_point(random, scale);
      const ClosestSegments found = closest_segments(a0, a1, b0, b1);
      inside += found.inside_first() && found.inside_second();
      if (!proven(found, a0, a1, b0, b1, 1e-9 * scale)) FAIL_CHECK("segments ", i, " at scale ", scale);
    }
  CHECK(inside > 3000);
}

TEST_CASE("crossing, parallel, overlapping and empty segments have their closed forms") {
  const auto of = [](Vec3d a0, Vec3d a1, Vec3d b0, Vec3d b1) { return closest_segments(a0, a1, b0, b1); };
  // The saddle: each edge passes over the other's middle.
  const ClosestSegments saddle = of({-1, 0, 0.5}, {1, 0, 0.5}, {0, -2, 0}, {0, 2, 0});
  CHECK(saddle.s == 0.5);
  CHECK(saddle.t == 0.5);
  CHECK(saddle.offset == Vec3d{0, 0, 0.5});
  CHECK((saddle.inside_first() && saddle.inside_second()));
  // Beside each other: any pair of points opposite is as near, and an end is taken.
  const ClosestSegments beside = of({0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {9, 3, 0});
  CHECK(beside.distance == 3);
  CHECK_FALSE((beside.inside_first() && beside.inside_second()));
  // On one line: overlapping, then apart.
  CHECK(of({0, 0, 0}, {4, 0, 0}, {3, 0, 0}, {9, 0, 0}).distance == 0);
  const ClosestSegments apart = of({0, 0, 0}, {4, 0, 0}, {9, 0, 0}, {6, 0, 0});
  CHECK(apart.distance == 2);
  CHECK(apart.s == 1);
  CHECK(apart.t == 1);
  // Points.
  const ClosestSegments point = of({2, 1, 0}, {2, 1, 0}, {0, 0, 0}, {4, 0, 0});
  CHECK(point.distance == 1);
  CHECK(point.t == 0.5);
  CHECK_FALSE(point.inside_first());
  CHECK(of({0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 1, 0}).s == 0.5);
  CHECK(of({0, 3, 0}, {0, 3, 0}, {4, 0, 0}, {4, 0, 0}).distance == 5);
}

TEST_CASE("almost parallel segments are as near as their best sample, at three scales") {
  Random random(16);
  for (const double scale : kScales)
    for (int i = 0; i < 2000; ++i) {
      const double tilt = scale * std::pow(10, -1 - i % 16);
      const Vec3d a0 = random_point(random, scale), a1 = random_point(random, scale);
      const Vec3d shift = random_point(random, 0.3 * scale);
      const Vec3d b0 = a0 + shift + random_point(random, tilt), b1 = a1 + shift + random_point(random, tilt);
      const ClosestSegments found = closest_segments(a0, a1, b0, b1);
      // The distance is that of the points it names, and convex in s: sampled in s, with t solved for.
      const Vec3d p = a0 + found.s * (a1 - a0), q = b0 + found.t * (b1 - b0);
      CHECK(std::abs(length(p - q) - found.distance) < 1e-14 * scale);
      double least = 1e300;
      for (int k = 0; k <= 200; ++k)
        least = std::min(least, closest_on_segment(a0 + (k / 200.0) * (a1 - a0), b0, b1).distance);
      CHECK(found.distance <= least + 1e-12 * scale);
      CHECK(found.distance >= least - length(a1 - a0) / 400);
    }
}

TEST_CASE("gaps take the radius off, and are negative inside") {
  CHECK(gap_of({0, 3, 4}, 2).distance == 3);
  CHECK(gap_of({0, 3, 4}, 2).direction == Vec3d{0, 0.6, 0.8});
  CHECK(gap_of({0, 0.5, 0}, 2).distance == -1.5);
  CHECK(gap_of({0, 0, 0}, 2).direction == Vec3d{0, 1, 0});
  CHECK(plane_gap({5, 1, 7}, {0, 3, 0}, {0, 1, 0}).distance == -2);
}
