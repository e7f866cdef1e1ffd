// The Voronoi cones of features, where they can be written down, and a floor of triangles in double.
#include <doctest/doctest.h>

#include <cmath>

#include "contact/reference/proximity/cones.hpp"
#include "contact/rules/contact_law.hpp"
#include "mesh/grid.hpp"
#include "mesh/primitives.hpp"
#include "rig.hpp"
#include "soup.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

/// Two triangles at the edge 0-1, along z; the other corners lie at x = -1 and 1, at this height [m].
Features bent(double height) {
  return features_of({{0, 0, 0}, {0, 0, 1}, {-1, height, 0.5}, {1, height, 0.5}}, {{0, 1, 2}, {1, 0, 3}});
}
/// `sides` triangles around an apex at the origin, whose rim lies at this height.
Features tent(std::uint32_t sides, double height, bool closed) {
  std::vector<Vec3d> places{{0, 0, 0}};
  std::vector<mesh::Triangle> triangles;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double turn = 2 * std::acos(-1.0) * k / sides;
    places.push_back({std::cos(turn), height, std::sin(turn)});
    if (closed || k + 1 < sides) triangles.push_back({0, 1 + (k + 1) % sides, 1 + k});
  }
  return features_of(places, triangles);
}
Vec3d leaning(double slope) { return {slope, 1, 0}; }

/// Whether the pair of a cloth vertex at p and triangle t acts.
bool meets(const Features& object, std::uint32_t t, const Vec3d& p) {
  const Features cloth = features_of({p, p + Vec3d{0, 9, 0}, p + Vec3d{9, 9, 9}}, {{0, 1, 2}});
  FeaturePair pair;
  pair.kind = PairKind::VertexObjectTriangle;
  pair.a = 0;
  pair.b = t;
  const FeaturePair now = measured(pair, cloth, object);
  return now.inside && now.in_cones;
}
/// Whether a vertex of the obstacle, which lies at p, acts on triangle t of cloth.
bool pricks(const Features& object, std::uint32_t vertex, const Features& cloth, std::uint32_t t) {
  FeaturePair pair;
  pair.kind = PairKind::ObjectVertexTriangle;
  pair.a = vertex;
  pair.b = t;
  const FeaturePair now = measured(pair, cloth, object);
  return now.inside && now.in_cones;
}
/// Whether the edge from p to q of a lone triangle of cloth acts on edge 0-1 of the obstacle.
bool crosses_over(const Features& object, const Vec3d& p, const Vec3d& q) {
  const Features cloth = features_of({p, q, {0.5, 9, 0.5}}, {{0, 1, 2}});
  FeaturePair pair;
  pair.kind = PairKind::EdgeObjectEdge;
  pair.a = 0;
  pair.b = 0;
  REQUIRE(cloth.edges[0] == mesh::Edge{0, 1});
  REQUIRE(object.edges[0] == mesh::Edge{0, 1});
  const FeaturePair now = measured(pair, cloth, object);
  return now.inside && now.in_cones;
}

/// How far a sheet of 0.04 m goes along x that lies on a flat floor of triangles with legs of `cell` [m], in the
/// 0.05 s in which the floor moves at 2 m/s.
double dragged(double cell, const std::string& friction) {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
      "time": {"substeps": 8},
    "contact": {"method": "proximity", "thickness": 0.005}, "cloths": [{"grid": [3, 3], "size": [0.04, 0.04],
      "plane": "xz", "density": 0.3, "damping": 0.0003, "transform": {"translate": [0.0013, 0.005, 0.0007]},
      "stiffness": {"structural": 0.5, "shear": 0.1, "bend": 0.003}}],
    "colliders": [{"kind": "mesh", "mesh": "floor", "friction": )" +
                                            friction + R"(,
      "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 2}}]})",
                                        "floor.json");
  REQUIRE_OK(scene);
  const auto assets = load_assets(*scene, [&](const std::string&) -> Result<mesh::TriangleMesh> {
    const auto count = [&](double length) {
      return 1 + static_cast<std::uint32_t>(std::lround(length / cell));
    };
    const mesh::Grid grid{count(0.2), count(0.08), 0.2, 0.08};
    mesh::TriangleMesh floor;
    for (std::uint32_t j = 0; j < grid.ny; ++j)
      for (std::uint32_t i = 0; i < grid.nx; ++i) {
        const mesh::RestPoint p = mesh::rest_point(grid, i, j);
        floor.positions.push_back(Vec3d{p.x - 0.14, 0, p.y - 0.04}.to<float>());
      }
    floor.triangles = mesh::grid_triangles(grid);
    return floor;
  });
  REQUIRE_OK(assets);
  auto simulation = Simulation::create(*scene, *assets);
  REQUIRE_OK(simulation);
  const auto mean = [&] {
    double sum = 0;
    for (const Vec3d& p : simulation->positions()) sum += p.x;
    return sum / static_cast<double>(simulation->positions().size());
  };
  const double before = mean();
  advance(*simulation, 3);
  MESSAGE("cell ", cell, " m, friction ", friction, ": ", 1000 * (mean() - before), " mm");
  return mean() - before;
}

}  // namespace

TEST_CASE("in double a floor of triangles drags a sheet by its friction and no more") {
  const double rubbed = 0.5 * 0.5 * 9.81 * 0.0025;  // in 0.05 s, by a friction of 0.5
  for (const double cell : {0.005, 0.02}) {
    CHECK(std::abs(dragged(cell, "0")) < 0.02 * rubbed);
    // 48 substeps, each with the velocity at its end, go 1/48 further.
    CHECK(dragged(cell, "0.5") == doctest::Approx(rubbed * 49 / 48).epsilon(0.005).scale(0));
  }
}

TEST_CASE("the edge of a ridge has a cone between the normals of its sides, that of a valley none") {
  const double s = 0.5;  // of both sides
  const mesh::Edge edge{0, 1};
  for (const double lean : {-0.499, -0.3, 0.0, 0.499}) CHECK(in_cone_of_edge(bent(-s), edge, leaning(lean)));
  for (const double lean : {-0.51, 0.51, 3.0}) CHECK_FALSE(in_cone_of_edge(bent(-s), edge, leaning(lean)));
  for (const double lean : {-1.0, -0.5, 0.0, 0.2, 0.5})
    CHECK_FALSE(in_cone_of_edge(bent(s), edge, leaning(lean)));
  // Seen from below the valley is a ridge.
  CHECK(in_cone_of_edge(bent(s), edge, -leaning(0.3)));
}

TEST_CASE("the edge of a flat floor has its normal and no other direction, but for the slack of rounding") {
  const mesh::Edge edge{0, 1};
  for (const double lean : {0.0, 0.9 * kConeSlack, -0.9 * kConeSlack})
    CHECK(in_cone_of_edge(bent(0), edge, leaning(lean)));
  for (const double lean : {1.1 * kConeSlack, -1.1 * kConeSlack, 1.0})
    CHECK_FALSE(in_cone_of_edge(bent(0), edge, leaning(lean)));
  const Features floor = tent(6, 0, true);
  CHECK(in_cone_of_vertex(floor, 0, leaning(0)));
  CHECK_FALSE(in_cone_of_vertex(floor, 0, leaning(2 * kConeSlack)));
  CHECK(in_cone_of_vertex(floor, 0, -leaning(0)));
}

TEST_CASE("the apex of a tent has the cone that its edges leave, that of a pit none") {
  const Features roof = tent(4, -0.5, true), pit = tent(4, 0.5, true);
  for (const double lean : {0.0, 0.49, -0.49}) {
    CHECK(in_cone_of_vertex(roof, 0, leaning(lean)));
    CHECK_FALSE(in_cone_of_vertex(pit, 0, leaning(lean)));
  }
  CHECK_FALSE(in_cone_of_vertex(roof, 0, leaning(0.51)));
}

TEST_CASE("at the border of an open mesh a direction may lead outward") {
  const Features one = features_of({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0.5}}, {{0, 1, 2}});
  for (const double lean : {0.0, 0.5, 100.0}) CHECK(in_cone_of_edge(one, {0, 1}, leaning(lean)));
  CHECK(in_cone_of_edge(one, {0, 1}, {1, 0, 0}));
  CHECK_FALSE(in_cone_of_edge(one, {0, 1}, leaning(-0.01)));
  // A vertex of a straight border, x = 0, of a sheet at x < 0.
  const Features half = features_of({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}}, {{0, 1, 2}, {0, 2, 3}});
  for (const double lean : {0.0, 0.5, 100.0}) CHECK(in_cone_of_vertex(half, 0, leaning(lean)));
  CHECK_FALSE(in_cone_of_vertex(half, 0, leaning(-0.01)));
  CHECK_FALSE(in_cone_of_vertex(half, 0, {1, 1, 0.01}));
}

TEST_CASE("of an edge with three triangles a direction must lead off all of them") {
  const Features fins = features_of({{0, 0, 0}, {0, 0, 1}, {-1, 0, 0.5}, {1, 0, 0.5}, {0.5, 1, 0.5}},
                                    {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK_FALSE(in_cone_of_edge(fins, {0, 1}, {0, 1, 0}));
  CHECK(in_cone_of_edge(fins, {0, 1}, {0, -1, 0}));
}

TEST_CASE("the sides of a fold meet beside it, though each is nearer to the other in the fold") {
  constexpr double kCell = 0.04;
  const mesh::Grid grid{7, 3, 6 * kCell, 2 * kCell};
  const double lean = std::acos(-1.0) / 36;  // of each side, from upright
  std::vector<Vec3d> places;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const double along = (i - 3.0) * kCell;
      places.push_back({along * std::sin(lean), std::abs(along) * std::cos(lean), j * kCell});
    }
  const Features cloth = features_of(places, mesh::grid_triangles(grid));
  // Of each column of one side, the pairs of its vertices with triangles that have one of the other.
  std::vector<int> meet(4, 0);
  for (std::uint32_t vertex = 0; vertex < places.size(); ++vertex)
    for (std::uint32_t t = 0; t < cloth.triangles.size(); ++t) {
      const mesh::Triangle& corners = cloth.triangles[t];
      const auto is_across = [&](std::uint32_t corner) { return corner % grid.nx > 3; };
      if (vertex % grid.nx >= 3 || std::none_of(corners.begin(), corners.end(), is_across)) continue;
      FeaturePair pair;
      pair.kind = PairKind::VertexTriangle;
      pair.a = vertex;
      pair.b = t;
      const FeaturePair now = measured(pair, cloth, {});
      if (now.inside && now.in_cones && now.distance < kCell / 2) ++meet[3 - vertex % grid.nx];
    }
  CHECK(meet[1] > 0);   // a cell beside the fold, where it keeps its sides apart
  CHECK(meet[3] == 0);  // farther away the fold is nearer
}

TEST_CASE("a vertex beside a triangle meets it only where no neighbour of the triangle is nearer") {
  // Over the right side of the hinge, 0.2 m from the edge. Triangle 0 is the left one.
  for (const double height : {-0.5, 0.0, 0.5}) {
    const Features object = bent(height);
    const Vec3d over_right = Vec3d{0.2, 0.2 * height, 0.5} + 0.1 * Vec3d{-height, 1, 0};
    CHECK_FALSE(meets(object, 0, over_right));
    CHECK(meets(object, 1, over_right));
  }
  // Over a ridge both have the edge nearest; over a valley each has its inside.
  for (const double height : {-0.5, 0.0, 0.5})
    for (const std::uint32_t t : {0U, 1U}) CHECK(meets(bent(height), t, {0, 0.1, 0.5}));
  // Beyond the border of the mesh.
  CHECK(meets(bent(0), 1, {0.9, 0.1, 0.9}));
  CHECK(meets(bent(0), 1, {1.1, 0.1, 0.5}));
}

TEST_CASE("an edge over the edge of a box acts, over the diagonal of its flat side only along the normal") {
  CHECK(crosses_over(bent(-1), {-0.5, 0.1, 0.4}, {0.5, 0.1, 0.6}));
  CHECK(crosses_over(bent(0), {-0.5, 0.1, 0.4}, {0.5, 0.1, 0.6}));
  CHECK_FALSE(crosses_over(bent(0), {-0.5, 0.05, 0.4}, {0.5, 0.15, 0.6}));  // its lower end is nearer
  CHECK_FALSE(crosses_over(bent(1), {-0.5, 0.6, 0.4}, {0.5, 0.6, 0.6}));    // so are the valley's sides
}

TEST_CASE("a vertex of a flat floor pricks cloth over it along its normal, a spike also leaning cloth") {
  const Features flat = features_of({{-1, 0.1, -1}, {-1, 0.1, 1}, {1, 0.1, 0}}, {{0, 1, 2}});
  const Features tilted = features_of({{-1, 0.0, -1}, {-1, 0.0, 1}, {1, 0.2, 0}}, {{0, 1, 2}});
  const Features floor = tent(6, 0, true), spike = tent(6, -3, true);
  CHECK(pricks(floor, 0, flat, 0));
  CHECK_FALSE(pricks(floor, 0, tilted, 0));
  CHECK(pricks(spike, 0, flat, 0));
  CHECK(pricks(spike, 0, tilted, 0));
  // A sheet of two triangles that meet beside the spike: the one that is not over it has a nearer neighbour.
  const Features sheet =
      features_of({{0.1, 0.1, -1}, {0.1, 0.1, 1}, {-1, 0.1, 0}, {1, 0.1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(pricks(spike, 0, sheet, 0));
  CHECK_FALSE(pricks(spike, 0, sheet, 1));
}

TEST_CASE("what has a radius has no cone") {
  Features bar = features_of({}, {});
  bar.add_capsule({-1, -0.3, 0.5}, {2, -0.3, 0.5}, 0.25);
  bar.add_sphere({0, -0.3, 0.5}, 0.25);
  const Features cloth = bent(-0.1);  // about the bar: its edge is not the nearest
  for (const FeaturePair& pair : object_pairs(cloth, bar, trees_of(bar), 0.2))
    CHECK(measured(pair, cloth, bar).in_cones);
}

TEST_CASE("of all pairs of two surfaces the nearest lies in the cones of both features") {
  Random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    const mesh::TriangleMesh ball = mesh::make_sphere(8, 6);
    std::vector<Vec3d> places;
    const Vec3d apart = Vec3d{2.3, 0, 0} + random_point(random, 0.1);
    for (const Vec3f& p : ball.positions) places.push_back(1.0 * p.to<double>() + random_point(random, 0.1));
    const Features cloth = features_of(places, ball.triangles);
    places.clear();
    for (const Vec3f& p : ball.positions)
      places.push_back(apart + p.to<double>() + random_point(random, 0.1));
    const Features object = features_of(places, ball.triangles);
    const std::vector<FeaturePair> pairs = object_pairs_by_brute_force(cloth, object, 1);
    REQUIRE(!pairs.empty());
    double least = 1;
    for (const FeaturePair& pair : pairs) least = std::min(least, pair.distance);
    for (const FeaturePair& pair : pairs)
      if (const FeaturePair now = measured(pair, cloth, object); now.distance == least && now.inside)
        CHECK(now.in_cones);
  }
}
