// The list of near features: trees against all pairs, and lists that can be written down.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/reference/proximity/near_list.hpp"
#include "mesh/grid.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

Features features(const Soup& soup) { return features_of(soup.positions, soup.triangles); }

bool equal(const std::vector<FeaturePair>& x, const std::vector<FeaturePair>& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const FeaturePair& a, const FeaturePair& b) {
    return same_features(a, b) && a.distance == b.distance && a.direction == b.direction &&
           a.weights_a == b.weights_a && a.weights_b == b.weights_b && a.inside == b.inside;
  });
}

std::size_t count(const std::vector<FeaturePair>& pairs, PairKind kind) {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [&](const FeaturePair& p) { return p.kind == kind; }));
}

/// p_A - p_B of a pair, from its weights.
Vec3d offset_of(const FeaturePair& pair, const Features& a, const Features& b) {
  Vec3d sum;
  const auto add = [&](const Features& of, const auto& vertices, const std::array<double, 3>& weights) {
    for (std::size_t k = 0; k < vertices.size(); ++k) sum += weights[k] * of.positions[vertices[k]];
  };
  const std::array<std::uint32_t, 1> vertex{pair.a};
  switch (pair.kind) {
    case PairKind::VertexTriangle:
    case PairKind::VertexObjectTriangle:
    case PairKind::ObjectVertexTriangle:
      add(a, vertex, pair.weights_a);
      add(b, b.triangles[pair.b], pair.weights_b);
      break;
    default:
      add(a, a.edges[pair.a], pair.weights_a);
      add(b, b.edges[pair.b], pair.weights_b);
  }
  return sum;
}

const Soup kSquare{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};

}  // namespace

TEST_CASE("the trees list the pairs of all features against all, with the same numbers") {
  Random random(31);
  for (const auto& [cloth_count, object_count, size, reach] :
       {std::tuple{60U, 1U, 0.2, 0.05}, {120U, 200U, 0.06, 0.03}, {90U, 40U, 0.3, 0.01}}) {
    Features cloth = features(random_soup(random, cloth_count, size));
    Features object = features(random_soup(random, object_count, size));
    object.add_sphere({0.1, 0.1, 0.1}, 0.3);
    object.add_capsule({-0.4, 0, 0}, {0.2, 0.3, 0}, 0.1);
    cloth.positions[7].y = std::nan("");
    const std::vector<FeaturePair> self = self_pairs(cloth, reach);
    const std::vector<FeaturePair> with = object_pairs(cloth, object, trees_of(object), reach);
    CHECK(equal(self, self_pairs_by_brute_force(cloth, reach)));
    CHECK(equal(with, object_pairs_by_brute_force(cloth, object, reach)));
    CHECK(count(self, PairKind::VertexTriangle) > 0);
    CHECK(count(self, PairKind::EdgeEdge) > 5);
    CHECK(count(with, PairKind::ObjectVertexTriangle) > 5);
    CHECK(count(with, PairKind::EdgeObjectEdge) > 5);
    CHECK((object_count == 1 || count(with, PairKind::VertexObjectTriangle) > 0));
    CHECK(std::is_sorted(with.begin(), with.end()));
    CHECK(self_pairs(cloth, 0).empty());
  }
}

TEST_CASE(
    "a list that is kept while things move gives what a search gives, and searches again after a jump") {
  Random random(33);
  Features cloth = features(random_soup(random, 80, 0.1)), object = features(random_soup(random, 60, 0.1));
  object.add_capsule({-0.4, 0, 0}, {0.2, 0.3, 0}, 0.1);
  NearList list;
  for (int step = 0; step < 60; ++step) {
    const double jump = step % 20 == 19 ? 0.3 : 0.001;
    for (Vec3d& p : cloth.positions) p += random_point(random, jump);
    for (Vec3d& p : object.positions) p += random_point(random, 0.001);
    const NearList::Reach reach{random.uniform(0.02, 0.025), random.uniform(0.02, 0.025)};
    const std::vector<FeaturePair> near = list.near(cloth, object, reach, 0.01);
    std::vector<FeaturePair> searched = self_pairs(cloth, reach.self);
    const std::vector<FeaturePair> more = object_pairs(cloth, object, trees_of(object), reach.object);
    searched.insert(searched.end(), more.begin(), more.end());
    CHECK(equal(near, searched));
    CHECK(near.size() > 50);
  }
  CHECK(list.searches() >= 3);  // one at the start, one after each jump but the last
  CHECK(list.searches() < 30);
  for (const FeaturePair& pair : list.near(cloth, object, {0, 0.02}, 0.01))
    CHECK(pair.kind > PairKind::EdgeEdge);
}

TEST_CASE("weights sum to one on each side, and to the offset of the closest points") {
  Random random(32);
  const Features cloth = features(random_soup(random, 100, 0.1)),
                 object = features(random_soup(random, 80, 0.1));
  std::vector<FeaturePair> pairs = self_pairs(cloth, 0.05);
  const std::vector<FeaturePair> more = object_pairs(cloth, object, trees_of(object), 0.05);
  pairs.insert(pairs.end(), more.begin(), more.end());
  CHECK(pairs.size() > 300);
  for (const FeaturePair& pair : pairs) {
    double a = 0, b = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(pair.weights_a[k] >= 0);
      CHECK(pair.weights_b[k] <= 0);
      a += pair.weights_a[k];
      b += pair.weights_b[k];
    }
    CHECK(std::abs(a - 1) < 1e-14);
    CHECK(std::abs(b + 1) < 1e-14);
    const bool self = pair.kind <= PairKind::EdgeEdge, from = pair.kind == PairKind::ObjectVertexTriangle;
    const Vec3d offset = offset_of(pair, from ? object : cloth, self || from ? cloth : object);
    CHECK(length(offset - pair.distance * pair.direction) < 1e-13);
  }
}

TEST_CASE("two squares above each other have the pairs that a drawing shows") {
  // A square of two triangles and the same one 1 mm above, both with the diagonal 0-2.
  Soup two = kSquare;
  for (const Vec3d& p : kSquare.positions) two.positions.push_back(p + Vec3d{0, 0.001, 0});
  for (const mesh::Triangle& t : kSquare.triangles) two.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  const std::vector<FeaturePair> pairs = self_pairs(features(two), 0.01);
  // Each of the 8 vertices is above or below a corner of one triangle of the other square or of both: the
  // diagonal's ends of both. 4 * 2 + 4 * 1 = 12.
  CHECK(count(pairs, PairKind::VertexTriangle) == 12);
  // Edges above each other: 5. Edges that meet at a corner, one of each square: corners 0 and 2 have three
  // edges, so 3 * 3 - 3 each; corners 1 and 3 have two, 2 * 2 - 2 each: 16.
  CHECK(count(pairs, PairKind::EdgeEdge) == 21);
  for (const FeaturePair& pair : pairs) {
    CHECK(std::abs(pair.distance - 0.001) < 1e-17);
    CHECK(std::abs(pair.direction.y) == 1);
    CHECK(pair.inside == (pair.kind == PairKind::VertexTriangle));  // no edge crosses over another's inside
  }
}

TEST_CASE("features of cloth in cloth part across the triangle, by their numbers or by their fronts") {
  const Soup there{{{0, 1, 0}, {1, 1, 0}, {0, 1, 1}}, {{0, 1, 2}}};  // its front is below: (0, -1, 0)
  for (const bool turned : {false, true}) {
    CAPTURE(turned);
    Soup both = there;
    for (const Vec3d& p : there.positions) both.positions.push_back(p + Vec3d{0.1, 0, 0.1});
    both.triangles.push_back(turned ? mesh::Triangle{3, 5, 4} : mesh::Triangle{3, 4, 5});
    std::size_t corners = 0;
    for (const FeaturePair& pair : self_pairs(features(both), 1e-9)) {
      CHECK(pair.distance == 0);
      CHECK(pair.inside == (pair.kind == PairKind::VertexTriangle));
      if (pair.kind != PairKind::VertexTriangle) continue;
      ++corners;
      CHECK(pair.direction.x == 0);
      // The later one goes to the front of the first; turned, each to its own.
      CHECK(pair.direction.y == ((pair.a > 2) != turned ? -1 : 1) * (turned && pair.a < 3 ? -1 : 1));
    }
    CHECK(corners == 1);  // of the second in the first
  }
}

TEST_CASE("coplanar sheets side by side have pairs across the gap, along the sheet") {
  Soup apart = kSquare;
  for (const Vec3d& p : kSquare.positions) apart.positions.push_back(p + Vec3d{1.25, 0, 0});
  for (const mesh::Triangle& t : kSquare.triangles) apart.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  const std::vector<FeaturePair> pairs = self_pairs(features(apart), 0.3);
  CHECK(pairs.size() > 4);
  for (const FeaturePair& pair : pairs) {
    CHECK(pair.distance == 0.25);
    CHECK(std::abs(pair.direction.x) == 1);
  }
}

TEST_CASE("a flat sheet has no pairs with itself within half its shortest altitude") {
  const mesh::Grid grid{9, 7, 0.8, 0.6};
  Soup sheet;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const mesh::RestPoint p = mesh::rest_point(grid, i, j);
      sheet.positions.push_back({p.x, 0, p.y});
    }
  sheet.triangles = mesh::grid_triangles(grid);
  CHECK(self_pairs(features(sheet), 0.5 * 0.1 / std::sqrt(2)).empty());  // right triangles of 0.1 m
  CHECK_FALSE(self_pairs(features(sheet), 0.11).empty());
}

TEST_CASE("spheres and capsules have pairs with all features of cloth, planes with its vertices") {
  const Features cloth = features(kSquare);
  Features ball;
  ball.add_sphere({0.7, -0.5, 0.2}, 0.49);
  const std::vector<FeaturePair> near = object_pairs(cloth, ball, trees_of(ball), 0.02);
  REQUIRE(near.size() == 1);  // above triangle 0 only; the other is further away than 0.02 m
  CHECK(near[0].kind == PairKind::ObjectVertexTriangle);
  CHECK(near[0].distance == doctest::Approx(0.01));
  CHECK(near[0].direction == Vec3d{0, -1, 0});  // A is the ball, below
  const std::vector<FeaturePair> farther = object_pairs(cloth, ball, trees_of(ball), 0.15);
  REQUIRE(farther.size() == 3);  // and the other, and the vertex that is nearest
  CHECK(farther[2].kind == PairKind::VertexBall);
  CHECK(farther[2].a == 1);
  CHECK(farther[2].distance == doctest::Approx(std::hypot(0.3, 0.5, 0.2) - 0.49));
  CHECK(length(farther[2].direction - Vec3d{0.3, 0.5, -0.2} / std::hypot(0.3, 0.5, 0.2)) < 1e-12);
  Features bar;
  bar.add_capsule({-1, 0.3, 0.5}, {2, 0.3, 0.5}, 0.25);
  const std::vector<FeaturePair> across = object_pairs(cloth, bar, trees_of(bar), 0.06);
  CHECK(across.size() == 3);  // two sides and the diagonal; its ends are far
  for (const FeaturePair& pair : across) {
    CHECK(pair.kind == PairKind::EdgeObjectEdge);
    CHECK(pair.distance == doctest::Approx(0.05));
  }
  Features rail;
  rail.add_capsule({-1, -0.3, 0}, {0.5, -0.3, 0}, 0.25);
  std::vector<std::uint32_t> ends;
  for (const FeaturePair& pair : object_pairs(cloth, rail, trees_of(rail), 0.4))
    if (pair.kind == PairKind::VertexCapsule) {
      ends.push_back(pair.a);
      CHECK(pair.distance == doctest::Approx(pair.a == 0 ? 0.05 : std::hypot(0.5, 0.3) - 0.25));
      CHECK(pair.weights_b[0] + pair.weights_b[1] == doctest::Approx(-1));
    }
  CHECK(ends == std::vector<std::uint32_t>{0, 1});
  const scene::ColliderPlane plane{{0, 0.5, 0}, {0, 1, 0}};
  const std::vector<FeaturePair> below = plane_pairs(cloth, {&plane, 1}, 0.01);
  CHECK(below.size() == 4);
  for (const FeaturePair& pair : below) CHECK(pair.distance == -0.5);
}

TEST_CASE(
    "vertices that no triangle names and doubled ones: the first have no pairs, the second each its own") {
  Soup object = kSquare;
  object.positions.push_back({0.5, 0.01, 0.5});  // of no triangle
  const Features cloth = features({{{0.2, 0.02, 0.3}, {0.6, 0.02, 0.1}, {0.4, 0.5, 0.2}}, {{0, 1, 2}}});
  const std::size_t once = object_pairs(cloth, features(object), trees_of(features(object)), 0.05).size();
  object.positions.pop_back();
  CHECK(object_pairs(cloth, features(object), trees_of(features(object)), 0.05).size() == once);
  object.triangles.push_back(object.triangles[0]);  // a doubled triangle brings no new edge or vertex
  const std::vector<FeaturePair> doubled =
      object_pairs(cloth, features(object), trees_of(features(object)), 0.05);
  // One vertex is above the triangle that is there once, one above the other.
  CHECK(count(doubled, PairKind::VertexObjectTriangle) == 3);
}
