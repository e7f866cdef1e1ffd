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
  return {1, {0}, {1}, {0, 1, 0}, distance, kThickness, friction};
}
Response respond_one(const NearPair& pair, const Vec3d& velocity, double inverse_mass,
                     const ContactLaw& law) {
  const Vec3d v[] = {velocity};
  const double w[] = {inverse_mass};
  return respond({&pair, 1}, v, w, law);
}
Vec3d answered(const NearPair& pair, const Vec3d& velocity, double inverse_mass, double restitution = 0) {
  return velocity + respond_one(pair, velocity, inverse_mass, {kStep, restitution}).change[0];
}

std::vector<NearPair> near_pairs(const Features& cloth, const std::vector<FeaturePair>& pairs,
                                 double friction) {
  std::vector<NearPair> all;
  for (const FeaturePair& pair : pairs) {
    NearPair near{0, {}, {}, pair.direction, pair.distance, kThickness, friction, {}, {}, pair.inside};
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
    const Response response = respond({&pair, 1}, v, w, {kStep});
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
  CHECK(answered(ends, {0, -1, 0}, 1) == Vec3d{0, -1, 0});
}

TEST_CASE("one node on a floor comes to the thickness and no further, and what parts is left alone") {
  for (const double inverse_mass : {0.01, 1.0, 500.0}) {
    for (const double distance : {0.03, 0.011, 0.0102})
      for (const double speed : {5.0, 50.0, 500.0}) {
        if (distance - speed * kStep > kThickness) continue;
        const Vec3d after = answered(on_floor(distance, 0), {0, -speed, 0}, inverse_mass);
        CHECK(distance + kStep * after.y == doctest::Approx(kThickness).epsilon(1e-12).scale(0));
      }
    // Nearer than the thickness it comes no nearer, whatever the speed.
    for (const double distance : {0.009, 0.001, -0.5})
      CHECK(std::abs(answered(on_floor(distance, 0), {0, -50, 0}, inverse_mass).y) < 1e-12);
    CHECK(answered(on_floor(0.009, 0), {0, 9, 0}, inverse_mass).y == 9);
  }
  CHECK(answered(on_floor(0.001, 1), {1, -5, 0}, 0) == Vec3d{1, -5, 0});  // kinematic
}

TEST_CASE("a node returns from a floor with its restitution, and does not return from its own weight") {
  for (const double e : {0.0, 0.3, 1.0}) {
    const double least = e > 0 ? 2 * e : -0.0001 / kStep;  // without it, it comes to the thickness
    CHECK(answered(on_floor(0.0101, 0), {0, -2, 0}, 3, e).y == doctest::Approx(least));
    const double fallen = 9.81 * kStep;  // in a substep
    const Vec3d rests = respond_one(on_floor(kThickness, 0), {0, -fallen, 0}, 3, {kStep, e, 9.81}).change[0];
    CHECK(rests.y == doctest::Approx(fallen));
  }
}

TEST_CASE(
    "what is too near is pushed apart by a part of what is missing, no faster than it may, and keeps no "
    "speed") {
  const auto pushed = [](double distance, double step) {
    const Response response = respond_one(on_floor(distance, 0), {}, 5, {step});
    CHECK(response.change[0] == Vec3d{});
    return response.push[0].y;
  };
  for (const double step : {1e-2, 1e-3, 1e-4, 1e-6})
    for (const double distance : {0.0099, 0.005, 0.0, -0.5}) {
      const double missing = std::min(0.01 - distance, 0.01);
      const double part = 0.7 * std::min(1.0, missing / (0.02 * 0.01));  // softly near the thickness
      CHECK(pushed(distance, step) == doctest::Approx(std::min(part * missing, 0.5 * step)));
    }
  CHECK(pushed(0.01, 1e-3) == 0);
  CHECK(pushed(0.01001, 1e-3) == 0);
}

TEST_CASE("a pair begins with the force that it kept, but for what parts faster than its load") {
  NearPair pair = on_floor(kThickness, 0.5);
  pair.kept = {0, 3, 0};  // N on 2 kg: m g of 1.5 m/s²
  const auto left = [&](double speed, double load) {
    return respond_one(pair, {0, speed, 0}, 0.5, {kStep, 0, load}).impulses[0].y / kStep;
  };
  CHECK(left(-1.5 * kStep, 1.5) == doctest::Approx(3));  // it carries its load on
  CHECK(left(-2 * kStep, 1.5) == doctest::Approx(4));    // or what it has become
  CHECK(left(1 * kStep, 1.5) == 0);                      // alone it needs no more once it parts
  pair.kept = {1, 3, 0};
  const Response response = respond_one(pair, {-0.5 * kStep, -1.5 * kStep, 0}, 0.5, {kStep, 0, 1.5});
  CHECK(length(response.impulses[0] / kStep - Vec3d{1, 3, 0}) < 1e-12);  // also along the floor
}

TEST_CASE("friction takes the sliding whole, or as much as its coefficient allows, relative to the surface") {
  NearPair pair = on_floor(kThickness, 0.5);
  const Vec3d slow = answered(pair, {0.2, -1, 0.1}, 2), fast = answered(pair, {3, -1, 4}, 2);
  CHECK(std::abs(slow.x) < 1e-15);
  CHECK(std::abs(slow.z) < 1e-15);
  const double left = 1 - 0.5 * 1 / 5;  // J/m = 1 m/s
  CHECK(fast.x == doctest::Approx(3 * left).epsilon(1e-12).scale(0));
  CHECK(fast.z == doctest::Approx(4 * left).epsilon(1e-12).scale(0));
  pair.surface = {-0.25, 0, 0};  // the floor, side B, moves at 0.25 m/s along x
  CHECK(answered(pair, {0.2, -1, 0.1}, 2).x == doctest::Approx(0.25));
}

TEST_CASE("two pairs of one node share its mass, so that together they do what one does") {
  const NearPair twice[] = {on_floor(0.009, 0.4), on_floor(0.009, 0.4)};
  const Vec3d v[] = {{0.3, -20, 0}};
  const double w[] = {4};
  const Response response = respond(twice, v, w, {kStep});
  CHECK(response.acting[0] == 2 * 256);  // both would be below the floor
  const Vec3d one = answered(twice[0], v[0], 4);
  CHECK(length(v[0] + response.change[0] - one) < 1e-13);
}

TEST_CASE(
    "iterations bring a column of nodes to rest that one leaves in motion, and the force goes through to the "
    "floor") {
  // Eight nodes of 0.5 kg, one on the other, on a floor, which have fallen for a substep.
  constexpr std::uint32_t kNodes = 8;
  std::vector<NearPair> pairs = {on_floor(kThickness, 0)};
  for (std::uint32_t k = 1; k < kNodes; ++k)
    pairs.push_back({2, {k, k - 1}, {1, -1}, {0, 1, 0}, kThickness, kThickness, 0});
  const std::vector<Vec3d> v(kNodes, {0, -9.81 * kStep, 0});
  const std::vector<double> w(kNodes, 2.0);
  double fastest = 1;
  for (const std::uint32_t iterations : {1U, 10U, 100U, 10000U}) {
    const Response response = respond(pairs, v, w, {kStep, 0, {0, -9.81, 0}, {iterations}});
    double most = 0;
    for (std::uint32_t k = 0; k < kNodes; ++k) most = std::max(most, length(v[k] + response.change[k]));
    CHECK(most < fastest);
    fastest = most;
    if (iterations == 10000)
      for (std::uint32_t k = 0; k < kNodes; ++k)
        CHECK(response.impulses[k].y / kStep ==
              doctest::Approx((kNodes - k) * 0.5 * 9.81).epsilon(1e-6).scale(0));
  }
  CHECK(fastest < 1e-9);
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
    const Response response = respond(pairs, velocity, inverse_mass, {kStep, 0.5, {}, {3}});
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
    for (std::size_t i = 0; i < change.size(); ++i) CHECK(length(change[i] - response.change[i]) < 1e-10);
  }
}

TEST_CASE("pairs that share vertices never raise the kinetic energy, in any number of iterations") {
  Random random(42);
  for (int round = 0; round < 200; ++round) {
    std::vector<NearPair> pairs;
    std::vector<Vec3d> velocity;
    std::vector<double> inverse_mass;
    for (int i = 0; i < 4; ++i) {
      velocity.push_back(random_point(random, 1));
      inverse_mass.push_back(random.uniform(0.1, 10));
    }
    if (round % 4 == 1) inverse_mass[0] /= 100;
    for (int p = 0; p < 12; ++p) {
      const Vec3d n = Vec3d{0, 1, 0} + random_point(random, 0.3);
      const std::uint32_t a = random.below(4), b = (a + 1 + random.below(3)) % 4;
      pairs.push_back(
          {2, {a, b}, {1, -1}, n / length(n), kThickness * random.uniform(0.1, 1), kThickness, 0.5});
    }
    const bool heavy = round % 2 == 1;
    const ImpulseRule impulses{heavy ? 7 + random.below(58) : 1 + random.below(6), heavy};
    const Response response =
        respond(pairs, velocity, inverse_mass, {kStep, random.uniform(0, 1), {}, impulses});
    double before = 0, after = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3d now = velocity[i] + response.change[i];
      before += dot(velocity[i], velocity[i]) / inverse_mass[i];
      after += dot(now, now) / inverse_mass[i];
    }
    CHECK(after <= before + 1e-9);
  }
}
