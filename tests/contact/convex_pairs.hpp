// Triangles and convex bodies of all sorts, for the tests of their distance.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "contact/reference/pushes/convex_body.hpp"
#include "mesh/convex_hull.hpp"
#include "mesh/primitives.hpp"

namespace weft {

inline Vec3d random_point(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

inline mesh::TriangleMesh hull_of(const std::vector<Vec3f>& points) {
  auto hull = mesh::convex_hull(points);
  REQUIRE_MESSAGE(hull, hull.error().message);
  return std::move(*hull);
}

/// A hull of this many points of a ball or its surface, stretched.
inline mesh::TriangleMesh random_hull(Random& random, std::size_t count, const Vec3d& size) {
  std::vector<Vec3f> points;
  const bool surface = random.below(2) == 0;
  while (points.size() < count) {
    const Vec3d p = random_point(random);
    const double r = length(p);
    if (r > 1 || r < 0.05) continue;
    const Vec3d q = surface ? p / r : p;
    points.push_back(Vec3d{q.x * size.x, q.y * size.y, q.z * size.z}.to<float>());
  }
  const std::array<double, 4> turn{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), 1};
  return hull_of(mesh::transformed({points, {}}, 1, turn, random_point(random)).positions);
}

/// Tetrahedra, cubes, needles, slabs, and hulls of 4 to `most` points; about 1 m large.
inline std::vector<mesh::TriangleMesh> convex_bodies(std::size_t each, std::size_t most) {
  Random random(21);
  std::vector<mesh::TriangleMesh> bodies;
  for (std::size_t k = 0; k < each; ++k) {
    bodies.push_back(random_hull(random, 4, {1, 1, 1}));
    mesh::TriangleMesh cube = mesh::make_box({1, 1, 1});
    if (k > 0) cube = mesh::transformed(cube, 1, {random.uniform(-1, 1), 0.3, 0.1, 1}, random_point(random));
    bodies.push_back(hull_of(cube.positions));
    bodies.push_back(random_hull(random, 8, {1, 0.001, 0.001}));
    bodies.push_back(random_hull(random, 12, {1, 1, 0.001}));
    bodies.push_back(hull_of(mesh::make_box({1, 0.001, 1}).positions));
    bodies.push_back(random_hull(random, 5 + random.below(25), {1, 1, 1}));
    bodies.push_back(
        random_hull(random, 30 + random.below(static_cast<std::uint32_t>(most) - 29), {1, 0.7, 0.5}));
  }
  return bodies;
}

using CornersOfTriangle = std::array<Vec3f, 3>;
inline reference::TrianglePoints points_of(const CornersOfTriangle& t) {
  return {t[0].to<double>(), t[1].to<double>(), t[2].to<double>()};
}

enum class TriangleSort { Any, Small, Segment, Point, Corner, Edge, Face, Deep, Far, Large, Flush, Near };
inline constexpr int kTriangleSorts = 12;

/// A triangle near a body, of one of the sorts: those of Corner, Edge and Face touch it, up to the rounding of a place
/// in f32; one of Flush lies in the plane of a face; those of Near come from 1e-1 to 1e-8 of it.
inline CornersOfTriangle random_triangle(Random& random, const mesh::TriangleMesh& body, TriangleSort sort) {
  const auto any = [&](double size) { return (size * random_point(random)).to<float>(); };
  const mesh::Triangle& face =
      body.triangles[random.below(static_cast<std::uint32_t>(body.triangles.size()))];
  const Vec3d a = body.positions[face[0]].to<double>(), b = body.positions[face[1]].to<double>(),
              c = body.positions[face[2]].to<double>();
  const Vec3d normal = cross(b - a, c - a) / length(cross(b - a, c - a));
  const auto beside = [&](const Vec3d& at, double size) {
    return (at + size * random_point(random)).to<float>();
  };
  switch (sort) {
    case TriangleSort::Any:
      return {any(2), any(2), any(2)};
    case TriangleSort::Small: {
      const Vec3d at = 2 * random_point(random);
      return {beside(at, 0.05), beside(at, 0.05), beside(at, 0.05)};
    }
    case TriangleSort::Segment: {
      const Vec3f p = any(2), q = any(2);
      if (random.below(2) == 0) return {p, q, q};
      return {p, Vec3f{0.5F * (p.x + q.x), 0.5F * (p.y + q.y), 0.5F * (p.z + q.z)}, q};
    }
    case TriangleSort::Point: {
      const Vec3f p = any(2);
      return {p, p, p};
    }
    case TriangleSort::Corner:
    case TriangleSort::Edge:
    case TriangleSort::Face: {
      Vec3d at = a;
      if (sort == TriangleSort::Edge) at = 0.5 * (a + b);
      if (sort == TriangleSort::Face) at = (a + b + c) / 3;
      Vec3d out[2];
      for (Vec3d& way : out) {
        way = random_point(random);
        const double rise = dot(way, normal);
        if (rise < 0)
          way -= 2 * rise * normal;  // only roughly outside: beyond a corner's other faces it may go in
      }
      return {at.to<float>(), (at + out[0]).to<float>(), (at + out[1]).to<float>()};
    }
    case TriangleSort::Deep: {
      Vec3d middle;
      for (const Vec3f& p : body.positions)
        middle += p.to<double>() / static_cast<double>(body.positions.size());
      const double size = random.below(2) == 0 ? 0.01 : 0.5;
      return {beside(middle, size), beside(middle, size), beside(middle, size)};
    }
    case TriangleSort::Far: {
      const Vec3d at = 1e4 * random_point(random);
      return {beside(at, 1), beside(at, 1), beside(at, 1)};
    }
    case TriangleSort::Large:
      return {any(300), any(300), any(300)};
    case TriangleSort::Near: {
      const double s = random.uniform(0, 1), t = random.uniform(0, 1) * (1 - s);
      const Vec3d on = random.below(3) == 0   ? a
                       : random.below(2) == 0 ? a + s * (b - a)
                                              : a + s * (b - a) + t * (c - a);
      const Vec3d at = on + std::pow(10, random.uniform(-8, -1)) * random_point(random);
      const Vec3d way = random_point(random), other = random_point(random);
      const double u = random.uniform(-0.5, 0.5);
      if (random.below(2) == 0) return {at.to<float>(), (at + way).to<float>(), (at + other).to<float>()};
      return {(at + u * way).to<float>(), (at + (u - 1) * way).to<float>(), (at + other).to<float>()};
    }
    case TriangleSort::Flush: {
      const double s = random.uniform(-1, 1), t = random.uniform(-1, 1), u = random.uniform(-1, 1);
      return {a.to<float>(), (a + s * (b - a) + t * (c - a)).to<float>(), (b + u * (c - a)).to<float>()};
    }
  }
  return {};
}

}  // namespace weft
