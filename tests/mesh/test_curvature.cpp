#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "mesh/curvature.hpp"
#include "mesh/primitives.hpp"

using namespace weft;
using mesh::Curvature;

namespace {

std::vector<Vec3d> places_of(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> places;
  for (const Vec3f& p : mesh.positions) places.push_back(p.to<double>());
  return places;
}

/// A tube round z of these facets, without caps, of rings whose diagonals lean in turns.
struct Tube {
  std::vector<Vec3d> places;
  std::vector<mesh::Triangle> triangles;
};
Tube tube(double radius, std::uint32_t facets, std::uint32_t rings, double length) {
  Tube made;
  for (std::uint32_t j = 0; j <= rings; ++j)
    for (std::uint32_t i = 0; i < facets; ++i) {
      const double angle = 2 * std::numbers::pi * i / facets;
      made.places.push_back({radius * std::cos(angle), radius * std::sin(angle), length * j / rings});
    }
  for (std::uint32_t j = 0; j < rings; ++j)
    for (std::uint32_t i = 0; i < facets; ++i) {
      const std::uint32_t a = j * facets + i, b = j * facets + (i + 1) % facets, c = b + facets,
                          d = a + facets;
      if ((i + j) % 2 == 0) {
        made.triangles.insert(made.triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        made.triangles.insert(made.triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  return made;
}

}  // namespace

TEST_CASE("a tube turns by 1/R around itself and not along, whichever way its diagonals lean") {
  constexpr std::uint32_t kRings = 6;
  for (const std::uint32_t facets : {24U, 48U, 96U}) {
    const double radius = 0.05, angle = 2 * std::numbers::pi / facets;
    const Tube made = tube(radius, facets, kRings, 0.1);
    const std::vector<Curvature> at = mesh::vertex_curvatures(made.places, made.triangles);
    for (std::size_t v = facets; v < kRings * facets; ++v) {  // not at its ends
      const Vec3d& p = made.places[v];
      const Vec3d out{p.x / radius, p.y / radius, 0}, around{-out.y, out.x, 0}, along{0, 0, 1};
      CHECK(dot(at[v].normal, out) > 1 - angle * angle);
      // Facets turn by an angle over a chord of 2 R sin(angle / 2), and their sides lie up to half of it aside.
      CHECK(dot(around, at[v].shape * around) * radius == doctest::Approx(1).epsilon(0.3 * angle * angle));
      CHECK(std::abs(dot(along, at[v].shape * along)) * radius < 1e-9);
      CHECK(length(at[v].shape * out) * radius < angle);
    }
  }
}

TEST_CASE("a rod's side is round up to its ends, which are flat") {
  constexpr std::uint32_t kFacets = 32;
  constexpr double kRadius = 0.02;
  Tube rod = tube(kRadius, kFacets, 1, 1);  // two rings: every vertex of its side is at a rim
  for (const double z : {0.0, 1.0}) rod.places.push_back({0, 0, z});
  for (std::uint32_t i = 0; i < kFacets; ++i) {
    const std::uint32_t next = (i + 1) % kFacets;
    rod.triangles.insert(rod.triangles.end(),
                         {{2 * kFacets, next, i}, {2 * kFacets + 1, kFacets + i, kFacets + next}});
  }
  const std::vector<Curvature> at = mesh::vertex_curvatures(rod.places, rod.triangles);
  const double angle = 2 * std::numbers::pi / kFacets;
  for (std::size_t v = 0; v < 2 * kFacets; ++v) {
    const Vec3d& p = rod.places[v];
    const Vec3d out{p.x / kRadius, p.y / kRadius, 0}, around{-out.y, out.x, 0}, along{0, 0, 1};
    CHECK(dot(at[v].normal, out) > 1 - angle * angle);  // not the end's
    // Long triangles share a corner's area unevenly; the mean of a ring is exact.
    CHECK(dot(around, at[v].shape * around) > 0);
    CHECK(length(at[v].shape * along) * kRadius < angle);
  }
  double sum = 0;
  for (std::size_t v = 0; v < kFacets; ++v) {
    const Vec3d around{-rod.places[v].y / kRadius, rod.places[v].x / kRadius, 0};
    sum += dot(around, at[v].shape * around) * kRadius / kFacets;
  }
  CHECK(sum == doctest::Approx(1).epsilon(0.05));
  for (const std::size_t middle : {2 * kFacets, 2 * kFacets + 1})
    CHECK(length(at[middle].shape * Vec3d{1, 1, 1}) == 0);
}

TEST_CASE(
    "a finer ball turns more nearly by 1/R in every direction, and a hollow one by as much the other way") {
  double worst_before = 1;
  for (const int rows : {16, 32, 64}) {
    mesh::TriangleMesh ball = mesh::make_sphere(2 * rows, rows);
    double worst = 0;
    const auto watch = [&](double side) {
      const std::vector<Vec3d> places = places_of(ball);
      const std::vector<Curvature> at = mesh::vertex_curvatures(places, ball.triangles);
      for (std::size_t v = 0; v < places.size(); ++v) {
        if (std::abs(places[v].y) > 0.8 || std::abs(places[v].z) > 0.8)
          continue;  // poles, whichever axis has them
        const Vec3d out = places[v] / length(places[v]);
        const Vec3d pole = std::abs(out.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
        const Vec3d u = cross(out, pole) / length(cross(out, pole)), w = cross(out, u);
        for (const Vec3d& d : {u, w, (u + w) / std::sqrt(2.0)})
          worst = std::max(worst, std::abs(dot(d, at[v].shape * d) - side));
      }
    };
    watch(1);
    for (mesh::Triangle& t : ball.triangles) std::swap(t[1], t[2]);
    watch(-1);
    MESSAGE(rows, " rows: ", worst);
    CHECK(worst < 0.5 * worst_before);
    worst_before = worst;
  }
  CHECK(worst_before < 0.05);
}

TEST_CASE("a box, a plane and a rim turn nothing") {
  const mesh::TriangleMesh box = mesh::make_box({0.3, 0.2, 0.1});
  for (const Curvature& at : mesh::vertex_curvatures(places_of(box), box.triangles))
    CHECK(at.shape == Mat3{});
  const std::vector<Vec3d> flat{{0, 0, 0}, {1, 0, 0}, {0.3, 0.9, 0}, {1.5, 1.1, 0}};
  const std::vector<mesh::Triangle> two{{0, 1, 2}, {1, 3, 2}}, against{{0, 1, 2}, {2, 3, 1}};
  for (const Curvature& at : mesh::vertex_curvatures(flat, two)) CHECK(at.shape == Mat3{});
  // Two triangles that face opposite sides are no surface; one without area has no normal.
  for (const Curvature& at : mesh::vertex_curvatures(flat, against)) CHECK(at.shape == Mat3{});
  const std::vector<mesh::Triangle> thin{{0, 1, 2}, {1, 1, 2}};
  for (const Curvature& at : mesh::vertex_curvatures(flat, thin)) CHECK(std::isfinite(at.shape.x.x));
}
