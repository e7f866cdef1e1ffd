#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("the unit cube has its bounds, its volume, and faces outward") {
  const Bounds box = bounds(cube());
  CHECK(box.low == Vec3f{0, 0, 0});
  CHECK(box.high == Vec3f{1, 1, 1});
  CHECK(signed_volume(cube()) == doctest::Approx(1.0).epsilon(1e-15).scale(0));
  CHECK(bounds({}).high == Vec3f{});
}

TEST_CASE("a mesh without triangles, with a missing vertex or a coordinate that is not finite is refused") {
  CHECK(check_mesh(cube()));
  CHECK(check_mesh({{{0, 0, 0}}, {}}).error().message == "The mesh has no triangles.");
  TriangleMesh mesh = cube();
  mesh.triangles[3][1] = 8;
  CHECK(check_mesh(mesh).error().message == "Triangle 3 names vertex 8, but the mesh has only 8 vertices.");
  mesh = cube();
  mesh.positions[5].y = std::numeric_limits<float>::quiet_NaN();
  CHECK(check_mesh(mesh).error().kind == ErrorKind::Input);
  CHECK(check_mesh(mesh).error().message.find("Vertex 5 has the coordinate") == 0);
}

TEST_CASE("triangles without area are dropped and counted, thin ones stay") {
  TriangleMesh mesh = cube();
  mesh.positions.push_back({0.5F, 0.5F, 0.0F});    // on the line from 0 to 2
  mesh.positions.push_back({0.5F, 0.5F, 1e-30F});  // beside it
  mesh.positions.push_back(mesh.positions[0]);
  mesh.triangles.insert(mesh.triangles.begin(), {0, 0, 1});
  mesh.triangles.push_back({0, 8, 2});
  mesh.triangles.push_back({0, 9, 2});
  mesh.triangles.push_back({0, 10, 2});
  CHECK(drop_degenerate_triangles(mesh) == 3);
  CHECK(mesh.triangles.size() == 13);
  CHECK(mesh.triangles.back() == Triangle{0, 9, 2});
  CHECK(drop_degenerate_triangles(mesh) == 0);
}

TEST_CASE("a transform scales, then rotates, then translates") {
  const double half = std::sqrt(0.5);
  // A quarter turn about z takes x to y: (1, 0, 0) -> (2, 0, 0) -> (0, 2, 0) -> (10, 2, 0).
  const TriangleMesh moved = transformed(cube(), 2.0, {0.0, 0.0, half, half}, {10.0, 0.0, 0.0});
  CHECK(moved.positions[1].x == doctest::Approx(10.0));
  CHECK(moved.positions[1].y == doctest::Approx(2.0));
  CHECK(signed_volume(moved) == doctest::Approx(8.0));
  CHECK(same_bits(moved, transformed(cube(), 2.0, {0.0, 0.0, -3 * half, -3 * half}, {10.0, 0.0, 0.0})));
  CHECK(same_bits(cube(), transformed(cube(), 1.0, {0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0})));
  CHECK_FALSE(check_mesh(transformed(cube(), 1e300, {0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0})));
}
