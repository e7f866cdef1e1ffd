// Edges that are kept within a strain limit, and those beside ways that were held back, in double: by lengths, momentum
// and energy.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "moved.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// A net of edges that flies apart, for a substep of a second.
struct Net : Moved {
  std::vector<LimitedEdge> edges;
  std::vector<mesh::Edge> yielding;
  double yielding_time = 0;

  void fly(const Vec3d& from, const Vec3d& speed, double inverse) {
    add(from, inverse > 0 ? from + speed : from, inverse);
  }
  SubstepWays ways(std::uint32_t rounds) {
    return {start, inverse_mass, end, velocity, 1, rounds, edges, 0, {}, yielding, yielding_time};
  }
  double length_of(const mesh::Edge& edge) const { return length(end[edge[1]] - end[edge[0]]); }
  double length_of(const LimitedEdge& edge) const { return length(end[edge.b] - end[edge.a]); }
  /// The most by which an edge is longer than its limit and its start, as a part of that.
  double excess() const {
    double most = 0;
    for (const LimitedEdge& edge : edges) {
      const double longest =
          std::max(static_cast<double>(edge.longest), length(start[edge.b] - start[edge.a]));
      most = std::max(most, length_of(edge) / longest - 1);
    }
    return most;
  }
  /// The angular momentum of what is at these places.
  Vec3d turning_about(const std::vector<Vec3d>& places) const {
    Vec3d sum;
    for (std::size_t i = 0; i < velocity.size(); ++i)
      if (inverse_mass[i] > 0) sum += cross(places[i], velocity[i]) / inverse_mass[i];
    return sum;
  }
};

/// A square lattice of side 1 between nodes, each of which flies somewhere.
Net lattice(std::uint32_t side, Random& random, double speed, double limit) {
  Net net;
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i)
      net.fly({static_cast<double>(i), static_cast<double>(j), 0}, random_point(random, speed),
              random.uniform(0.2, 5));
  const auto longest = static_cast<float>(1 + limit);
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t at = j * side + i;
      if (i + 1 < side) net.edges.push_back({at, at + 1, longest});
      if (j + 1 < side) net.edges.push_back({at, at + side, longest});
    }
  return net;
}

}  // namespace

TEST_CASE("an edge that flies apart ends at its limit; what its ends have in common they keep") {
  for (const double inverse : {1.0, 0.1, 0.0}) {
    CAPTURE(inverse);
    Net net;
    net.fly({0, 0, 0}, {-1, 0.3, 0}, inverse);
    net.fly({1, 0, 0}, {2, 0.3, 0}, 1);
    net.edges.push_back({0, 1, 1.1F});
    const Vec3d momentum = net.momentum();
    truncate({}, {}, 99, net.ways(1));
    CHECK(net.length_of(net.edges[0]) == doctest::Approx(1.1));
    CHECK(length(net.end[1] - net.start[1] - net.velocity[1]) < 1e-12);  // it has gone its way
    if (inverse > 0) CHECK(length(net.momentum() - momentum) < 1e-12);
    if (inverse == 0) CHECK(length(net.end[0]) == 0);
  }
}

TEST_CASE("an edge that begins beyond its limit grows no longer, and is not thrown together") {
  Net net;
  net.fly({0, 0, 0}, {-1, 0, 0}, 1);
  net.fly({2, 0, 0}, {1, 0, 0}, 1);
  net.edges.push_back({0, 1, 1.1F});
  truncate({}, {}, 99, net.ways(1));
  CHECK(net.length_of(net.edges[0]) == doctest::Approx(2));
  CHECK(length(net.velocity[1] - net.velocity[0]) < 1e-12);
  Net shrinking;
  shrinking.fly({0, 0, 0}, {0.1, 0, 0}, 1);
  shrinking.fly({2, 0, 0}, {-0.1, 0, 0}, 1);
  shrinking.edges.push_back({0, 1, 1.1F});
  truncate({}, {}, 99, shrinking.ways(6));
  CHECK(shrinking.length_of(shrinking.edges[0]) == doctest::Approx(1.8));
}

TEST_CASE("a net that flies apart comes within its limits, keeps its momentum and gains no energy") {
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    Net net = lattice(7, random, random.uniform(0.1, 3), random.uniform(0.01, 0.5));
    const Vec3d momentum = net.momentum();
    double kinetic = net.kinetic(), excess = net.excess();
    for (int blow = 0; blow < 30; ++blow) {
      const std::vector<Vec3d> places = net.end;  // the impulses act along edges as they are there
      const Vec3d turning = net.turning_about(places);
      separate({}, {}, 999, net.ways(1));
      CHECK(net.kinetic() <= kinetic * (1 + 1e-12));
      CHECK(length(net.momentum() - momentum) < 1e-9);
      CHECK(length(net.turning_about(places) - turning) < 1e-9);
      kinetic = net.kinetic();
    }
    CHECK(net.excess() < std::max(0.02, 0.2 * excess));
  }
}

TEST_CASE("a vertex with many edges at once gains no energy by any of them") {
  Random random(6);
  for (int round = 0; round < 200; ++round) {
    Net net;  // a hub and its rim, which flies off
    net.fly({0, 0, 0}, random_point(random, 1), random.uniform(0.01, 20));
    for (std::uint32_t k = 1; k <= 40; ++k) {
      const double angle = 0.157 * k;
      const Vec3d out{std::cos(angle), std::sin(angle), 0};
      net.fly(out, random.uniform(0, 3) * out + random_point(random, 1), random.uniform(0.01, 20));
      net.edges.push_back({0, k, 1.05F});
      if (k > 1) net.edges.push_back({k - 1, k, 0.16F});
    }
    const Vec3d momentum = net.momentum();
    double kinetic = net.kinetic();
    for (int blow = 0; blow < 20; ++blow) {
      separate({}, {}, 999, net.ways(1));
      CHECK(net.kinetic() <= kinetic * (1 + 1e-12));
      CHECK(length(net.momentum() - momentum) < 1e-7);
      kinetic = net.kinetic();
    }
  }
}

TEST_CASE("edges are not stretched beside ways that were held back, but by what that has paid for") {
  // A chain of unit edges that flies sideways at unit speed, and whose first node is stopped.
  const auto fly = [](bool stopped, double yielding_time) {
    Net net;
    for (std::uint32_t k = 0; k < 12; ++k) {
      net.fly({static_cast<double>(k), 0, 0}, {0, 0, 1}, 1);
      if (k > 0) net.yielding.push_back({k - 1, k});
    }
    net.yielding_time = yielding_time;
    const SolidPlane wall{0, {0, 0, -1}, 0, 0};
    net.start[0].z = net.end[0].z = -1e-9;  // before it
    net.end[0].z = 1;
    truncate(std::span(&wall, stopped ? 1 : 0), {}, 99, net.ways(0));
    return net;
  };
  for (const Vec3d& end : fly(false, 0).end) CHECK(end.z == 1);  // they are the solver's
  const Net held = fly(true, 0);
  for (std::uint32_t k = 0; k < 12; ++k) CHECK(held.end[k].z == doctest::Approx(k <= 6 ? 0 : 1).scale(1));
  for (const double part :
       {0.02, 0.1}) {  // each lets its next go on, the farther the more it has lost itself
    const Net giving = fly(true, part);
    double way = 0;
    for (std::uint32_t k = 1; k <= 6; ++k) {
      const double longest = 1 + part * (1 - way);
      way = std::min(1.0, way + std::sqrt(longest * longest - 1));
      CHECK(giving.end[k].z == doctest::Approx(way).epsilon(2e-3));
      CHECK(giving.velocity[k].z == doctest::Approx(giving.end[k].z));
    }
  }
}

TEST_CASE("cloth that flies close behind what is shortened for an edge does not fly into it") {
  // A chain as above; behind each of its nodes flies another one, nearer than it goes.
  constexpr double kGap = 0.3, kMargin = 0.02;
  constexpr std::uint32_t kNodes = 12;
  Net net;
  std::vector<ClothPair> pairs;
  for (std::uint32_t k = 0; k < kNodes; ++k) {
    net.fly({static_cast<double>(k), 0, 0}, {0, 0, 1}, 1);
    if (k > 0) net.yielding.push_back({k - 1, k});
  }
  for (std::uint32_t k = 0; k < kNodes; ++k) {
    net.fly({static_cast<double>(k), 0, -kGap}, {0, 0, 1}, 1);
    pairs.push_back({1, 1, {k, kNodes + k}, {0, 0, 1}, -0.5 * kGap, kMargin, 2 * kMargin, kGap});
  }
  const SolidPlane wall{0, {0, 0, -1}, 0, 0};
  net.start[0].z = -1e-9;
  truncate(std::span(&wall, 1), pairs, 99, net.ways(0));
  for (std::uint32_t k = 0; k < kNodes; ++k) {
    CHECK(net.end[k].z - net.end[kNodes + k].z >= 2 * kMargin - 1e-12);
    CHECK(net.end[k].z == doctest::Approx(k <= 6 ? 0 : 1).scale(1));
  }
}

TEST_CASE("beside a way that was held back what the scene moves goes its way, and what an obstacle drives") {
  Net moved;
  moved.add({0, 0, 0}, {-3, 0, 0}, 0);
  moved.fly({1, 0, 0}, {-3, 0, 0}, 1);
  moved.yielding.push_back({0, 1});
  const SolidPlane stops{1, {1, 0, 0}, 1 - 1e-9, 0};
  truncate(std::span(&stops, 1), {}, 99, moved.ways(0));
  CHECK(moved.end[0].x == -3);
  CHECK(moved.end[1].x == doctest::Approx(1));
  Net driven;
  driven.fly({0, 0, 0}, {}, 0);
  driven.fly({1, 0, 0}, {0.1, 0, 0}, 1);
  driven.yielding.push_back({0, 1});
  const SolidPlane comes{1, {1, 0, 0}, 1.8, 1};
  truncate(std::span(&comes, 1), {}, 99, driven.ways(0));
  CHECK(driven.end[1].x >= 1.8 - 1e-12);
}

TEST_CASE("ways are only shortened for edges, stretch them less for it, and energy is no more") {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    Net net = lattice(7, random, random.uniform(0.1, 2), 0);
    std::vector<SolidPlane> stops;
    for (std::uint32_t node = 0; node < 49; ++node)
      if (random.uniform(0, 1) < 0.1) stops.push_back({node, {0, 0, 1}, net.start[node].z - 1e-3, 0});
    for (const LimitedEdge& edge : net.edges) net.yielding.push_back({edge.a, edge.b});
    net.edges.clear();
    net.yielding_time = random.uniform(0, 0.5);
    const Net free = net;
    Net held = net;
    held.yielding.clear();
    truncate(stops, {}, 99, held.ways(0));
    truncate(stops, {}, 99, net.ways(0));
    CHECK(net.kinetic() <= held.kinetic());
    // What springs would have to bear that neither began so nor was led there by its solver.
    const auto strained = [&](const Net& ended) {
      double sum = 0;
      for (const mesh::Edge& edge : free.yielding) {
        const double begun = length(free.start[edge[1]] - free.start[edge[0]]);
        const double more = std::max(0.0, ended.length_of(edge) - std::max(begun, free.length_of(edge)));
        sum += more * more;
      }
      return sum;
    };
    CHECK(strained(net) <= strained(held));
    for (std::size_t node = 0; node < net.end.size(); ++node) {
      const Vec3d way = held.end[node] - held.start[node], left = net.end[node] - net.start[node];
      CHECK(length(cross(way, left)) < 1e-12);
      CHECK(dot(way, left) >= 0);
      CHECK(length(left) <= length(way) * (1 + 1e-12));
    }
  }
}
