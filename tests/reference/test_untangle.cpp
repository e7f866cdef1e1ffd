// The ways apart of what crosses, in cases that are known, and sheets that come apart in double.
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "contact/reference/proximity/untangle.hpp"
#include "contact/rules/contact_law.hpp"
#include "mesh/primitives.hpp"
#include "mesh/sheet_rim.hpp"
#include "rig.hpp"

using namespace weft;
using namespace weft::reference;

namespace {

constexpr CrossingFace kFloor{{Vec3d{-9, 0, 9}, Vec3d{9, 0, 9}, Vec3d{0, 0, -18}},
                              {5, 5, 5}};  // its normal is up

/// A sheet of 0.4 m by 0.4 m, turned about z by an angle whose half has this sine.
std::string sheet(int side, const std::string& at, double half_sine) {
  const std::string count = std::to_string(side);
  return R"({"grid": [)" + count + "," + count +
         R"(], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {"translate": )" +
         at + R"(, "rotate": [0, 0, )" + std::to_string(half_sine) + "," +
         std::to_string(std::sqrt(1 - half_sine * half_sine)) + "]}}";
}

}  // namespace

TEST_CASE("a tip that pokes up through a floor is drawn down, one that pokes down is drawn up") {
  for (const double up : {1.0, -1.0}) {
    // Two faces of a pyramid and the edge between them, from its tip to its base; the rims do not care.
    const Vec3d tip{0, up, 0}, base{1, -up, 0}, left{0, -up, 1}, right{0, -up, -1};
    const CrossingFace side{{tip, base, left}, {9, 9, 9}};
    const Vec3d way = way_apart(side, 0, right, kFloor);
    CHECK(way.y * up < -0.99);
    CHECK(length(way) <= 1 + 1e-12);
  }
}

TEST_CASE("flat cloth is drawn through by its outer part, whichever way triangles and edges are turned") {
  // An upright strip through the floor: its rim is near below, then near above.
  for (const double below : {1.0, -1.0})
    for (const bool turned : {false, true}) {
      const Vec3d p{0, -1, 0}, q{0, 1, 0}, r{1, 0, 0}, opposite{-1, 0, 0};
      // r grows upward by one a metre, or falls.
      CrossingFace own{{p, q, r}, {2 - below, 2 + below, 2}};
      if (turned) own = {{q, p, r}, {2 + below, 2 - below, 2}};
      const Vec3d way = way_apart(own, 0, opposite, kFloor);
      CHECK(way.y == doctest::Approx(kRimPart * below));
      CHECK(std::abs(way.x) + std::abs(way.z) < 1e-12);
    }
}

TEST_CASE("out of a closed mesh cloth goes along its own normal, to the side where the mesh's is") {
  CrossingFace body = kFloor;
  body.kind = SurfaceKind::ClosedMesh;
  const Vec3d p{0, -1, 0}, q{1, 1, 0}, r{0, 0, 9};  // at 27 degrees from upright
  const CrossingFace own{{p, q, r}, {1, 1, 1}};
  const Vec3d normal = cross(q - p, r - p) / length(cross(q - p, r - p));
  const Vec3d way = way_apart(own, 0, {}, body);
  CHECK(way.y > 0);
  CHECK(std::abs(dot(way, normal)) > 0.9 * length(way));
}

TEST_CASE("a rim's distance is zero at its farthest vertex, and each connected part has its own") {
  const std::vector<Vec3d> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {11, 0, 0}, {9, 2, 0}};
  const std::vector<mesh::Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
  const std::vector<double> rims = rim_distances(positions, triangles);
  CHECK(*std::min_element(rims.begin(), rims.begin() + 3) == 0);
  CHECK(*std::min_element(rims.begin() + 3, rims.end()) == 0);
  for (std::size_t v = 0; v < 3; ++v) CHECK(rims[v + 3] == doctest::Approx(2 * rims[v]));
}

TEST_CASE("a mesh has an outside only if it is closed, of one turn, and its volume is positive") {
  mesh::TriangleMesh ball = mesh::make_sphere(8, 6);
  const std::vector<Vec3d> places = widened(ball.positions);
  CHECK(faces_outward(places, ball.triangles));
  std::vector<mesh::Triangle> other = ball.triangles;
  std::swap(other[3][0], other[3][1]);
  CHECK_FALSE(faces_outward(places, other));
  other = ball.triangles;
  other.pop_back();
  CHECK_FALSE(faces_outward(places, other));
  other = ball.triangles;
  for (mesh::Triangle& t : other) std::swap(t[0], t[1]);
  CHECK_FALSE(faces_outward(places, other));
  other = ball.triangles;
  other.push_back(other[0]);
  CHECK_FALSE(faces_outward(places, other));
}

TEST_CASE("the corner across an edge is the other triangle's, none at a rim, and a fin sees the first") {
  //   2 - 3     and 4 above the edge 1 2
  //   | \ |
  //   0 - 1
  const std::vector<mesh::Triangle> triangles = {{0, 1, 2}, {1, 3, 2}, {2, 1, 4}};
  const std::vector<mesh::Triangle> corners = opposite_corners(triangles);
  CHECK(corners[0] == mesh::Triangle{kNoCorner, 3, kNoCorner});
  CHECK(corners[1] == mesh::Triangle{kNoCorner, kNoCorner, 0});
  CHECK(corners[2] == mesh::Triangle{0, kNoCorner, kNoCorner});
}

TEST_CASE("in double, crossed sheets come apart and a sheet comes out of a box, at a bounded speed") {
  for (const bool box : {false, true}) {
    CAPTURE(box);
    Simulation simulation = simulation_of_text(
        R"("gravity": [0, 0, 0], "time": {"substeps": 8}, "contact": {"method": "proximity", "thickness": 0.01},
           "cloths": [)" +
        sheet(8, "[0.03, 0.04, 0.02]", 0) +
        (box ? R"(], "colliders": [{"kind": "box", "center": [-0.2, 0, 0], "size": [0.2, 0.2, 0.2]}])"
             : "," + sheet(7, "[0.1, 0.03, 0.05]", 0.5) + "]"));
    std::uint32_t frames = 0;
    double fastest = 0;
    do {
      advance(simulation, 1);
      for (const Vec3d& v : simulation.velocities()) fastest = std::max(fastest, length(v));
      if (frames == 0) CHECK(simulation.proximity()->crossings() > 10);
    } while (++frames < 40 && simulation.proximity()->crossings() > 0);
    MESSAGE("apart after ", frames, " frames, fastest ", fastest, " m/s");
    CHECK(simulation.proximity()->crossings() == 0);
    CHECK(fastest < 4 * kUntanglePart * 0.01 / simulation.step());
    CHECK(self_crossings({simulation.positions(), simulation.triangles()}).empty());
  }
}
