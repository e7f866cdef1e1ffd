// The answer to near pairs: closed forms of one pair, and what sums must be for many.
#include <doctest/doctest.h>

#include <cmath>

#include "contact/reference/proximity/pairs.hpp"
#include "contact/reference/proximity/respond.hpp"
#include "contact/rules/contact_law.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr double kStep = 1.0 / 1024, kThickness = 0.01;

/// A node above a floor that stands.
NearPair on_floor(double distance, double friction) {
  return {1, {0}, {1}, {0, 1, 0}, distance, kThickness, friction, {}, true};
}
Vec3d answered(const NearPair& pair, const Vec3d& velocity, double inverse_mass, double damping) {
  const Vec3d v[] = {velocity};
  const double w[] = {inverse_mass};
  return velocity + respond({&pair, 1}, v, w, {kStep, damping}).change[0];
}

std::vector<NearPair> near_pairs(const Features& cloth, const std::vector<FeaturePair>& pairs,
                                 double friction) {
  std::vector<NearPair> all;
  for (const FeaturePair& pair : pairs) {
    NearPair near{0, {}, {}, pair.direction, pair.distance, kThickness, friction, {}, pair.inside};
    const auto add = [&](std::uint32_t node, double weight) {
      near.nodes[near.node_count] = node;
      near.weights[near.node_count++] = weight;
    };
    if (pair.kind == PairKind::VertexTriangle) {
      add(pair.a, 1);
      for (std::size_t k = 0; k < 3; ++k) add(cloth.triangles[pair.b][k], pair.weights_b[k]);
    } else {
      for (std::size_t k = 0; k < 2; ++k) add(cloth.edges[pair.a][k], pair.weights_a[k]);
      for (std::size_t k = 0; k < 2; ++k) add(cloth.edges[pair.b][k], pair.weights_b[k]);
    }
    all.push_back(near);
  }
  return all;
}

}  // namespace

TEST_CASE("the damping of a contact is the closed form of its restitution") {
  for (const double e : {1.0, 0.999, 0.75, 0.5, 0.3, 1e-3, 1e-300}) {
    const double pi = std::acos(-1.0), ratio = -std::log(e) / std::sqrt(pi * pi + std::log(e) * std::log(e));
    CHECK(contact_damping(e) == doctest::Approx(2 * ratio * std::sqrt(0.25)).epsilon(1e-14));
  }
  CHECK(contact_damping(0) == 1);  // 2 √0.25
}

TEST_CASE("a pair's urgency is one at the thickness and grows with the square of the depth to 256") {
  for (const double gap : {3.0, 1.0}) CHECK(contact_urgency(gap * kThickness, kThickness) == 1);
  CHECK(contact_urgency(kThickness / 2, kThickness) == 1 + 63);   // 255 / 4 = 63.75
  CHECK(contact_urgency(kThickness / 4, kThickness) == 1 + 143);  // 255 * 9 / 16 = 143.4
  for (const double gap : {0.0, -1.0}) CHECK(contact_urgency(gap * kThickness, kThickness) == 256);
}

TEST_CASE("a pair acts when it touches, or would after the substep, and counts by its urgency") {
  const auto acts = [](double distance, double speed) {
    const NearPair pair = on_floor(distance, 0);
    const Vec3d v[] = {{0, -speed, 0}};
    const double w[] = {1};
    const Response response = respond({&pair, 1}, v, w, {kStep, 0});
    const double gap = distance - std::max(speed, 0.0) * kStep;
    CHECK(response.acting[0] == (response.acts[0] ? contact_urgency(gap, kThickness) : 0));
    return static_cast<bool>(response.acts[0]);
  };
  CHECK(acts(0.00999, -1));
  // Features no further than a thousandth of the thickness beyond it touch, whatever their speed.
  CHECK(acts(0.010009, -1));
  CHECK_FALSE(acts(0.010011, 0));
  CHECK_FALSE(acts(0.02, 0.009989 / kStep));
  CHECK(acts(0.02, 0.009991 / kStep));
  CHECK(acts(0.02, 0.0176 / kStep));
  NearPair ends = on_floor(0.001, 0);
  ends.may = false;
  CHECK(answered(ends, {0, -1, 0}, 1, 0) == Vec3d{0, -1, 0});
}

TEST_CASE("one node on a floor: the spring below the thickness, the wall at a quarter of it") {
  for (const double inverse_mass : {0.01, 1.0, 500.0}) {
    // At rest, 1 mm too near: β 1 mm a step. With a rising speed: ζ of it is taken, but nothing pulls.
    CHECK(answered(on_floor(0.009, 0), {}, inverse_mass, 0.6).y == doctest::Approx(0.25 * 0.001 / kStep));
    CHECK(answered(on_floor(0.009, 0), {0, 0.05, 0}, inverse_mass, 0.6).y ==
          doctest::Approx(0.05 + 0.25 * 0.001 / kStep - 0.6 * 0.05));
    CHECK(answered(on_floor(0.009, 0), {0, 9, 0}, inverse_mass, 0.6).y == 9);
    // So fast that only the wall stops it: it arrives at h / 4.
    const Vec3d stopped = answered(on_floor(0.009, 0), {0, -50, 0}, inverse_mass, 0.6);
    CHECK(0.009 + kStep * stopped.y == doctest::Approx(kThickness / 4));
    const Vec3d from_afar = answered(on_floor(0.03, 0), {0, -50, 0}, inverse_mass, 0.6);
    CHECK(0.03 + kStep * from_afar.y == doctest::Approx(kThickness / 4));
    // Slower: ζ of what takes it beyond the thickness is taken, and with ζ = 1 it arrives at the thickness.
    CHECK(answered(on_floor(0.03, 0), {0, -25, 0}, inverse_mass, 0.6).y ==
          doctest::Approx(-25 + 0.6 * (25 - 0.02 / kStep)));
    const Vec3d arrived = answered(on_floor(0.03, 0), {0, -25, 0}, inverse_mass, 1);
    CHECK(0.03 + kStep * arrived.y == doctest::Approx(kThickness));
    // The missing gap is cut at h: far inside, the spring asks no more.
    CHECK(answered(on_floor(-0.5, 0), {0, 900, 0}, inverse_mass, 0).y ==
          doctest::Approx(900 + 0.25 * 0.01 / kStep));
  }
  CHECK(answered(on_floor(0.001, 1), {1, -5, 0}, 0, 0.6) == Vec3d{1, -5, 0});  // kinematic
}

TEST_CASE("friction takes the sliding whole, or as much as its coefficient allows, relative to the surface") {
  NearPair pair = on_floor(0.01 - 1e-9, 0.5);
  // Falling at 1 m/s, the wall lets 0.0075 m a step: 7.68 m/s, so the spring's damper acts: J/m = 0.6 m/s.
  const Vec3d slow = answered(pair, {0.2, -1, 0.1}, 2, 0.6), fast = answered(pair, {3, -1, 4}, 2, 0.6);
  CHECK(std::abs(slow.x) < 1e-15);
  CHECK(std::abs(slow.z) < 1e-15);
  const double left = 1 - 0.5 * (0.6 + 0.25 * 1e-9 / kStep) / 5;
  CHECK(fast.x == doctest::Approx(3 * left).epsilon(1e-12));
  CHECK(fast.z == doctest::Approx(4 * left).epsilon(1e-12));
  pair.surface = {-0.25, 0, 0};  // the floor, side B, moves at 0.25 m/s along x
  CHECK(answered(pair, {0.2, -1, 0.1}, 2, 0.6).x == doctest::Approx(0.25));
}

TEST_CASE("two pairs of one node share its mass, so that together they do what one does") {
  const NearPair twice[] = {on_floor(0.009, 0.4), on_floor(0.009, 0.4)};
  const Vec3d v[] = {{0.3, -20, 0}};
  const double w[] = {4};
  const Response response = respond(twice, v, w, {kStep, 0.6});
  CHECK(response.acting[0] == 2 * 256);  // both would be below the floor
  const Vec3d one = answered(twice[0], v[0], 4, 0.6);
  CHECK(length(v[0] + response.change[0] - one) < 1e-13);
}

TEST_CASE("of two pairs of one node the deeper gets nearly all of its mass") {
  // Floors on opposite sides: the one is deep, the other would be met just so.
  NearPair above = on_floor(0.0105, 0);
  above.direction = {0, -1, 0};
  const NearPair both[] = {on_floor(0.0012, 0), above};
  const Vec3d v[] = {{0, 0.6, 0}};
  const double w[] = {4};
  const Response response = respond(both, v, w, {kStep, 0.6});
  const double deep = contact_urgency(0.0012, kThickness),
               shallow = contact_urgency(0.0105 - 0.6 * kStep, kThickness);
  CHECK(shallow == 1);
  const double up = 0.25 * 0.0088 / kStep - 0.6 * 0.6, down = 0.6 * (0.6 - 0.0005 / kStep);
  CHECK(response.change[0].y ==
        doctest::Approx((deep * up - shallow * down) / (deep + shallow)).epsilon(1e-12));
}

TEST_CASE("impulses of cloth with cloth sum to no momentum, and each pair's weights to zero") {
  Random random(41);
  for (int round = 0; round < 5; ++round) {
    const Features cloth = [&] {
      const Soup soup = random_soup(random, 60, 0.1);
      return features_of(soup.positions, soup.triangles);
    }();
    std::vector<double> inverse_mass;
    std::vector<Vec3d> velocity;
    for (std::size_t i = 0; i < cloth.positions.size(); ++i) {
      inverse_mass.push_back(random.uniform(10, 1000));
      velocity.push_back(random_point(random, 20));
    }
    const std::vector<NearPair> pairs = near_pairs(cloth, self_pairs(cloth, 0.04), 0.3);
    const Response response = respond(pairs, velocity, inverse_mass, {kStep, 0.5});
    Vec3d momentum;
    double size = 0;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
      momentum += response.change[i] / inverse_mass[i];
      size += length(response.change[i]) / inverse_mass[i];
    }
    CHECK(size > 1e-3);
    CHECK(length(momentum) < 1e-14 * size);
    // The changes are those of the impulses, and no impulse pulls or exceeds its cone.
    std::vector<Vec3d> change(velocity.size());
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const Vec3d& impulse = response.impulses[p];
      const double normal = dot(impulse, pairs[p].direction);
      CHECK(normal >= 0);
      CHECK(length(impulse - normal * pairs[p].direction) <= 0.3 * normal + 1e-12);
      for (std::size_t k = 0; k < 4; ++k)
        change[pairs[p].nodes[k]] += (pairs[p].weights[k] * inverse_mass[pairs[p].nodes[k]]) * impulse;
    }
    CHECK(change == response.change);
  }
}

TEST_CASE("pairs that share vertices never raise the kinetic energy while their springs are empty") {
  // At d = h the spring is empty: contacts then take energy only, however many share a vertex.
  Random random(42);
  for (int round = 0; round < 200; ++round) {
    std::vector<NearPair> pairs;
    std::vector<Vec3d> velocity;
    std::vector<double> inverse_mass;
    for (int i = 0; i < 4; ++i) {
      velocity.push_back(random_point(random, 1));
      inverse_mass.push_back(random.uniform(0.1, 10));
    }
    for (int p = 0; p < 12; ++p) {
      const Vec3d n = Vec3d{0, 1, 0} + random_point(random, 0.3);
      const std::uint32_t a = random.below(4), b = (a + 1 + random.below(3)) % 4;
      pairs.push_back(
          {2, {a, b}, {1, -1}, n / length(n), kThickness * (1 - 1e-12), kThickness, 0.5, {}, true});
    }
    const Response response = respond(pairs, velocity, inverse_mass, {kStep, 0.6});
    double before = 0, after = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3d now = velocity[i] + response.change[i];
      before += dot(velocity[i], velocity[i]) / inverse_mass[i];
      after += dot(now, now) / inverse_mass[i];
    }
    CHECK(after <= before + 1e-9);
  }
}
