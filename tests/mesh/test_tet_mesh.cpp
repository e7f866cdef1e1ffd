#include <doctest/doctest.h>

#include <limits>

#include "base/random.hpp"
#include "mesh/check_tets.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/tet_quality.hpp"
#include "tet_checks.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

TetMesh one_tet() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}; }

// Two on both sides of the face 1 2 3.
TetMesh two_tets() {
  TetMesh mesh = one_tet();
  mesh.positions.push_back({1, 1, 1});
  mesh.tets.push_back({1, 2, 3, 4});
  return mesh;
}

std::string refusal(TetMesh mesh) {
  const auto checked = check_tets(mesh);
  if (checked) return "";
  CHECK(checked.error().kind == ErrorKind::Input);
  return checked.error().message;
}

std::array<Vec3d, 4> corners_of(const TetMesh& mesh, const Tet& tet) {
  std::array<Vec3d, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.positions[tet[k]].to<double>();
  return corners;
}

}  // namespace

TEST_CASE("six volumes are those of Cayley and Menger, and change sign with the order") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    std::array<Vec3d, 4> p;
    for (Vec3d& x : p) x = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    CHECK(std::abs(six_volumes(p)) / 6 == doctest::Approx(volume_by_lengths(p)).epsilon(1e-6));
    const double before = six_volumes(p);
    std::swap(p[1], p[3]);
    CHECK(six_volumes(p) == doctest::Approx(-before).epsilon(1e-9));
  }
  CHECK(six_volumes(corners_of(one_tet(), one_tet().tets[0])) == 1);
}

TEST_CASE(
    "the boundary of a block is a closed surface of one piece that faces outward, of the box's area and "
    "volume") {
  for (const std::array<std::uint32_t, 3> cells :
       {std::array<std::uint32_t, 3>{1, 1, 1}, {2, 1, 1}, {3, 4, 5}, {1, 7, 2}, {6, 6, 6}}) {
    const Vec3d size{0.5, 2, 0.75};
    const TetMesh made = block(cells, size);
    CHECK(made.positions.size() == (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1));
    CHECK(made.tets.size() == 5 * cells[0] * cells[1] * cells[2]);
    for (const auto& [face, count] : face_counts(made.tets)) CHECK(count <= 2);
    for (const Tet& tet : made.tets) CHECK(six_volumes(corners_of(made, tet)) > 0);

    const TriangleMesh skin = boundary_mesh(made);
    const SurfaceFaults faults = surface_faults(skin.triangles);
    CHECK(faults.edges == 0);
    CHECK(faults.vertices == 0);
    CHECK(euler_characteristic(skin.triangles) == 2);
    CHECK(area(skin) == doctest::Approx(2 * (0.5 * 2 + 2 * 0.75 + 0.75 * 0.5)).epsilon(1e-6));
    CHECK(signed_volume(skin) == doctest::Approx(0.5 * 2 * 0.75).epsilon(1e-6));
    CHECK(bounds(skin).low == Vec3f{-0.25F, -1, -0.375F});
    CHECK(bounds(skin).high == Vec3f{0.25F, 1, 0.375F});
    TetMesh same = made;
    REQUIRE(check_tets(same));
    CHECK(same.tets == made.tets);
    CHECK(same.positions == made.positions);
  }
}

TEST_CASE(
    "tetrahedra that are inside out are turned, and vertices that none has are dropped in their order") {
  TetMesh mesh = two_tets();
  mesh.tets[0] = {1, 0, 2, 3};  // seen from inside
  mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});
  mesh.positions.insert(mesh.positions.begin() + 3, {8, 8, 8});
  mesh.positions.push_back({7, 7, 7});
  for (Tet& tet : mesh.tets)
    for (std::uint32_t& vertex : tet) vertex += vertex < 2 ? 1 : 2;
  REQUIRE(check_tets(mesh));
  CHECK(mesh.positions == two_tets().positions);
  for (const Tet& tet : mesh.tets) CHECK(six_volumes(corners_of(mesh, tet)) > 0);
  CHECK(face_counts(mesh.tets) == face_counts(two_tets().tets));
  CHECK(surface_faults(boundary(mesh.tets)).edges == 0);
}

TEST_CASE("any block whose tetrahedra are turned at random comes back with its boundary") {
  Random random(2);
  const TetMesh good = block({3, 3, 3}, {1, 1, 1});
  for (int i = 0; i < 20; ++i) {
    TetMesh mesh = good;
    for (Tet& tet : mesh.tets)
      for (std::size_t k = 3; k > 0; --k)
        std::swap(tet[k], tet[random.below(static_cast<std::uint32_t>(k + 1))]);
    REQUIRE(check_tets(mesh));
    CHECK(signed_volume(boundary_mesh(mesh)) == doctest::Approx(1.0));
    CHECK(surface_faults(boundary(mesh.tets)).edges == 0);
  }
}

TEST_CASE("a tetrahedral mesh that cannot be used is refused with a sentence") {
  CHECK(refusal(one_tet()) == "");
  CHECK(refusal({}) == "The mesh has no tetrahedra.");
  TetMesh mesh = one_tet();
  mesh.positions[2].y = std::numeric_limits<float>::infinity();
  CHECK(refusal(mesh) == "Vertex 2 has the coordinate inf, which is not finite.");
  mesh = one_tet();
  mesh.tets[0][3] = 4;
  CHECK(refusal(mesh) == "Tetrahedron 0 names vertex 4, but the mesh has only 4 vertices.");
  mesh = two_tets();
  mesh.tets[1] = {1, 2, 1, 4};
  CHECK(refusal(mesh) == "Tetrahedron 1 names vertex 1 twice.");
  mesh = two_tets();
  mesh.positions[4] = {2, -1, 0};  // in the plane of 1, 2, 3
  CHECK(refusal(mesh).find(
            "Tetrahedron 1 is flat, so that it has no strain: six times its volume is 0 m^3") == 0);
  mesh = two_tets();
  mesh.positions.push_back({2, 2, 2});
  mesh.tets.push_back({1, 2, 3, 5});
  CHECK(refusal(mesh) == "The face of vertices 1, 2 and 3 belongs to 3 tetrahedra, more than 2.");
  mesh = two_tets();
  mesh.positions[4] = {-1, -1, -1};  // beyond vertex 0
  CHECK(refusal(mesh) ==
        "Tetrahedra 0 and 1 lie on the same side of their face of vertices 1, 2 and 3, one in the other.");
  mesh = one_tet();
  mesh.tets.push_back({0, 1, 2, 3});
  CHECK(refusal(mesh).find("Tetrahedra 0 and 1 lie on the same side") == 0);
}

TEST_CASE("a tetrahedron as flat as rounding makes one is refused, a thin one is not, at any size") {
  for (const float size : {1e-15F, 1.0F, 1e15F}) {
    TetMesh mesh = one_tet();
    for (Vec3f& x : mesh.positions) x *= size;
    mesh.positions[3] = {0.3F * size, 0.3F * size, 1e-4F * size};
    CHECK(refusal(mesh) == "");
    mesh.positions[3].z = 1e-8F * size;
    CHECK(refusal(mesh).find("Tetrahedron 0 is flat") == 0);
  }
}

TEST_CASE("the quality of tetrahedra with known angles") {
  // Regular: acos(1/3). A corner of a cube: three right angles, and three of acos(1 / sqrt 3).
  TetMesh mesh = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}};
  REQUIRE(check_tets(mesh));
  const TetQuality regular = tet_quality(mesh);
  CHECK(regular.least_angle == doctest::Approx(70.528779));
  CHECK(regular.largest_angle == doctest::Approx(70.528779));
  CHECK(regular.volume == doctest::Approx(8.0 / 3));
  const TetQuality corner = tet_quality(one_tet());
  CHECK(corner.least_angle == doctest::Approx(54.735610));
  CHECK(corner.largest_angle == doctest::Approx(90.0));
  CHECK(corner.least_volume == doctest::Approx(1.0 / 6));
  const TetQuality both = tet_quality(two_tets());
  CHECK(both.least_volume == doctest::Approx(1.0 / 6));
  CHECK(both.largest_volume == doctest::Approx(1.0 / 3));
  CHECK(both.volume == doctest::Approx(0.5));
  CHECK(tet_quality({}).volume == 0);
}
