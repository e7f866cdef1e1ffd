// The way between two places: what it is between places of known motions, and that no frame of reference is special.
#include <doctest/doctest.h>

#include <cmath>

#include "base/quaternion.hpp"
#include "base/random.hpp"
#include "base/trig.hpp"
#include "scene/screw.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Quaternion turned(const Vec3d& axis, double angle) {
  const Turn half = turn_of(0.5 * angle);
  const Vec3d a = axis / length(axis) * half.sine;
  return {a.x, a.y, a.z, half.cosine};
}

Vec3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}
Placement random_placement(Random& random) {
  return {random_vector(random, 3), turned(random_vector(random, 1), random.uniform(-3, 3))};
}

/// First `b`, then `a`.
Placement after(const Placement& a, const Placement& b) {
  return {matrix_of(a.rotation) * b.position + a.position, product(a.rotation, b.rotation)};
}

/// How far apart the two take the corners of a box of 2 m.
double apart(const RigidTransform& a, const RigidTransform& b) {
  double most = 0;
  for (const Vec3d& p : {Vec3d{1, 1, 1}, Vec3d{-1, 1, 0.5}, Vec3d{0.3, -1, -1}, Vec3d{}})
    most = std::max(most, length(a(p) - b(p)));
  return most;
}
double apart(const Placement& a, const Placement& b) { return apart(transform_of(a), transform_of(b)); }

}  // namespace

TEST_CASE("between two places of a rotation about any axis, the way is that rotation") {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const Vec3d axis = random_vector(random, 1), center = random_vector(random, 4);
    const MotionRotation motion{axis / length(axis), center, 1, std::nullopt, 0, 0};
    const auto place = [&](double angle) {
      const Quaternion q = turned(axis, angle);
      return Placement{center - matrix_of(q) * center, q};
    };
    const double begin = random.uniform(0, 3), angle = random.uniform(0.001, 3.1);  // less than half a turn
    const Screw way(place(begin), place(begin + angle));
    for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0})
      CHECK(apart(transform_of(way.at(part)), motion_at(motion, begin + part * angle)) < 1e-12);
  }
}

TEST_CASE("without a turn the way has the very places of a path") {
  const Placement from{{0.1, 0.2, 0.3}, turned({1, 2, 3}, 1)}, to{{0.7, -0.2, 1.3}, from.rotation};
  const MotionPath path{{{0, from.position}, {1, to.position}}};
  const Screw way(from, to);
  for (const double part : {0.0, 0.25, 0.7, 1.0}) {
    CHECK(way.at(part).position == motion_at(path, part).translation);
    CHECK(way.at(part).rotation == from.rotation);
  }
}

TEST_CASE("a way ends in the very places, and a part of a way is the way to there") {
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Placement from = random_placement(random), to = random_placement(random);
    const Screw way(from, to);
    CHECK(way.at(0) == from);
    CHECK(way.at(1) == to);
    CHECK(apart(way.at(1 - 1e-15), to) < 1e-13);
    CHECK(apart(Screw(from, way.at(0.5)).at(0.5), way.at(0.25)) < 1e-12);
  }
}

TEST_CASE(
    "the way does not depend on the frame in which its places are told, nor on where a body's origin is") {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Placement from = random_placement(random), to = random_placement(random),
                    other = random_placement(random);
    const Screw way(from, to);
    CHECK(apart(Screw(after(other, from), after(other, to)).at(0.3), after(other, way.at(0.3))) < 1e-11);
    CHECK(apart(Screw(after(from, other), after(to, other)).at(0.3), after(way.at(0.3), other)) < 1e-11);
  }
}

TEST_CASE("a point's way is as long as the sum of its pieces, and each takes the same time") {
  Random random(4);
  for (int k = 0; k < 50; ++k) {
    const Placement from = random_placement(random), to = random_placement(random);
    const Screw way(from, to);
    const Vec3d own = random_vector(random, 2);
    const double whole = way.length_of(transform_of(from)(own));
    constexpr int kPieces = 2000;
    for (int i : {0, 700, 1999}) {
      const Vec3d a = transform_of(way.at(double(i) / kPieces))(own),
                  b = transform_of(way.at(double(i + 1) / kPieces))(own);
      // The chord of an arc of at most pi / kPieces rad is shorter by its square / 24.
      CHECK(kPieces * length(b - a) == doctest::Approx(whole).epsilon(1.1e-7).scale(0));
    }
  }
}

TEST_CASE("a way that hardly turns is hardly other than straight") {
  for (const double angle : {1e-15, 1e-12, 1e-9, 1e-6}) {
    const Placement to{{1, -2, 0.5}, turned({1, 1, 0}, angle)};
    const Screw way(Placement{}, to), straight(Placement{}, Placement{to.position});
    for (const double part :
         {0.1, 0.5, 0.9})  // an arc of this angle over 2.3 m bulges by 1/8 of their product
      CHECK(length(way.at(part).position - straight.at(part).position) <= 0.3 * angle + 1e-15);
  }
}

TEST_CASE("a rotation and its negative are one place, and half a turn has a way") {
  const Quaternion q = turned({0, 1, 0}, 0.4), minus{-q[0], -q[1], -q[2], -q[3]};
  CHECK(Screw({{}, q}, {{1, 0, 0}, minus}).length_of({}) == 1);
  const Placement half = Screw({}, {{}, turned({0, 0, 1}, 3.141592653589793)}).at(0.5);
  CHECK(length(transform_of(half)({1, 0, 0}) - Vec3d{0, 1, 0}) < 1e-15);
}

TEST_CASE("a collider is where its ways have taken it, and stays between them") {
  const Placement a{{1, 0, 0}}, b{{1, 2, 0}};
  const MotionCarried motion{10, {{1, 2, {}, a}, {4, 5, a, b}}};
  const auto at = [&](double time) { return placement_at(motion, time).position; };
  CHECK(placement_at(MotionCarried{10}, 3) == Placement{});
  CHECK(at(0) == Vec3d{});
  CHECK(at(1.5) == Vec3d{0.5, 0, 0});
  CHECK(at(2) == a.position);
  CHECK(at(3) == a.position);
  CHECK(at(4) == a.position);
  CHECK(at(4 + 1e-9) == a.position);  // but for the rounding of a frame's time
  CHECK(at(4.25) == Vec3d{1, 0.5, 0});
  CHECK(at(5 - 1e-9) == b.position);
  CHECK(at(9) == b.position);
}
