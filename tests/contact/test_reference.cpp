// The oracle itself, against what is known without it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "contact/reference/pushes/analytic.hpp"
#include "contact/reference/pushes/lattice.hpp"
#include "contact/reference/pushes/pairs.hpp"
#include "contact/reference/pushes/pushes.hpp"
#include "contact/reference/pushes/winding.hpp"
#include "mesh/primitives.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

//  c
//  |\      the triangle (0,0,0) (4,0,0) (0,4,0), seen from +z
//  | \     .
//  a--b
constexpr LatticeTriangle kTriangle = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
const TrianglePoints kReal = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

struct SegmentCase {
  const char* what;
  LatticePoint from, to;
  bool meets;
};

const SegmentCase kSegments[] = {
    {"through the inside", {1, 1, -1}, {1, 1, 1}, true},
    {"through the inside, from the other side", {1, 1, 1}, {1, 1, -1}, true},
    {"u = 0", {0, 1, -1}, {0, 1, 1}, true},
    {"v = 0", {1, 0, -1}, {1, 0, 1}, true},
    {"u + v = 1", {2, 2, -1}, {2, 2, 1}, true},
    {"through a corner", {4, 0, -1}, {4, 0, 1}, true},
    {"past an edge", {3, 2, -1}, {3, 2, 1}, false},
    {"u < 0", {-1, 1, -1}, {-1, 1, 1}, false},
    {"t = 0", {1, 1, 0}, {1, 1, 2}, false},
    {"t = |d|", {1, 1, 2}, {1, 1, 0}, false},
    {"too short", {1, 1, 1}, {1, 1, 2}, false},
    {"the line behind", {1, 1, -2}, {1, 1, -1}, false},
    {"parallel, above", {0, 1, 1}, {2, 1, 1}, false},
    {"in the plane", {-1, 1, 0}, {5, 1, 0}, false},
    {"no length", {1, 1, 0}, {1, 1, 0}, false},
};

}  // namespace

TEST_CASE("a segment meets a triangle where the definition says, in integers and in double") {
  for (const SegmentCase& c : kSegments) {
    CAPTURE(c.what);
    CHECK(segment_meets(c.from, c.to, kTriangle) == c.meets);
    const auto real = [](const LatticePoint& p) { return Vec3<std::int64_t>{p[0], p[1], p[2]}.to<double>(); };
    const Verdict verdict = segment_triangle(real(c.from), real(c.to), kReal);
    CHECK(verdict == (c.meets ? Verdict::Hit : Verdict::Miss));
  }
}

TEST_CASE("the double verdict is ambiguous next to a bound and certain away from it") {
  const auto at = [](double x) {
    return segment_triangle({x, 1, -1}, {x, 1, 1}, kReal);
  };  // u + v = 1 at x = 3
  CHECK(at(3) == Verdict::Hit);
  CHECK(at(3 + 1e-6) == Verdict::Ambiguous);
  CHECK(at(3 + 1e-3) == Verdict::Miss);
  const auto ends_at = [](double z) { return segment_triangle({1, 1, -1}, {1, 1, z}, kReal); };
  CHECK(ends_at(-1e-3) == Verdict::Miss);
  CHECK(ends_at(1e-6) == Verdict::Ambiguous);
  CHECK(ends_at(1e-3) == Verdict::Hit);
}

TEST_CASE("a triangle through another is found from either, and a neighbour by its shared edge is not") {
  const LatticeTriangle needle = {{{1, 1, -2}, {1, 1, 2}, {9, 9, 2}}};
  CHECK(triangles_meet(needle, kTriangle));
  CHECK(triangles_meet(kTriangle, needle));
  const LatticeTriangle neighbour = {{{4, 0, 0}, {0, 4, 0}, {4, 4, 3}}};
  CHECK_FALSE(triangles_meet(kTriangle, neighbour));
}

TEST_CASE("brute force in double finds the ring where a plane cuts a sphere") {
  const mesh::TriangleMesh sphere = mesh::make_sphere(20, 20);
  const mesh::TriangleMesh sheet{{{-3, 0.03F, -3}, {3, 0.03F, -3}, {0, 0.03F, 5}}, {{0, 1, 2}}};
  const PairList pairs = find_pairs(sheet, sphere);
  CHECK(pairs.ambiguous.empty());
  CHECK(pairs.hits.size() == 40);  // one band of 20 quads, two triangles each
  for (const TrianglePair& pair : pairs.hits) {
    const TrianglePoints t = points_of(sphere, pair.object);
    CHECK(std::min({t.a.y, t.b.y, t.c.y}) < 0.03);
    CHECK(std::max({t.a.y, t.b.y, t.c.y}) > 0.03);
  }
}

TEST_CASE("a push takes the previous position to the thickness outside, is never inward, and is cut") {
  const PushLimits limits{0.5, 2.0};
  CHECK(push_length(0.2, limits) == doctest::Approx(0.3));
  CHECK(push_length(-1.0, limits) == doctest::Approx(1.5));
  CHECK(push_length(0.7, limits) == 0.0);
  CHECK(push_length(-9.0, limits) == 2.0);
  const mesh::TriangleMesh object{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};  // faces +z
  const std::vector<mesh::Triangle> cloth = {{0, 1, 2}};
  const std::vector<Vec3d> previous = {{1, 1, 0.25}, {1, 2, 0.75}, {2, 1, -1}};
  const std::vector<double> inverse_mass = {1, 1, 0};
  const std::vector<TrianglePair> pairs = {{0, 0}};
  const auto pushes = pushes_of(pairs, cloth, previous, inverse_mass, object, limits);
  CHECK(pushes[0].sum.z == doctest::Approx(0.25));
  CHECK(pushes[1].sum.z == 0.0);
  CHECK(pushes[1].count == 1);  // it counts in the mean, though it is far enough
  CHECK(pushes[2].count == 0);  // kinematic
}

TEST_CASE("a sphere and a plane know their distance and their outward normal") {
  const scene::ColliderSphere sphere{{1, 2, 3}, 0.5};
  CHECK(surface_at(sphere, {1, 4, 3}).distance == doctest::Approx(1.5));
  CHECK(surface_at(sphere, {1, 4, 3}).normal == Vec3d{0, 1, 0});
  CHECK(surface_at(sphere, {1, 2, 3}).distance == -0.5);
  CHECK(surface_at(sphere, {1, 2, 3}).normal == Vec3d{0, 1, 0});
  const scene::ColliderPlane plane{{0, 1, 0}, {0, 1, 0}};
  CHECK(surface_at(plane, {7, 0.25, 7}).distance == doctest::Approx(-0.75));
}

TEST_CASE("the winding number is one inside a sphere, zero outside, and a half in the middle of a half") {
  const mesh::TriangleMesh sphere = mesh::make_sphere(40, 40);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3d p{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    if (std::abs(length(p) - 1) < 0.02) continue;  // between the sphere and its facets
    CHECK(winding_number(p, sphere) == doctest::Approx(length(p) < 1 ? 1.0 : 0.0).epsilon(1e-9).scale(1));
    CHECK(inside(p, sphere) == (length(p) < 1));
  }
  mesh::TriangleMesh open = sphere;  // without its lower half: from the centre, half the directions
  std::erase_if(open.triangles, [&](const mesh::Triangle& t) {
    return sphere.positions[t[0]].y + sphere.positions[t[1]].y + sphere.positions[t[2]].y < 0;
  });
  CHECK(winding_number({0, 0, 0}, open) == doctest::Approx(0.5).epsilon(1e-6).scale(0));
}
