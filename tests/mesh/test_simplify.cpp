#include <doctest/doctest.h>

#include "mesh/primitives.hpp"
#include "mesh/simplify.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("a simplified sphere has as few triangles as asked, no unused vertex, and still its shape") {
  const TriangleMesh sphere = make_sphere(64, 64);
  const auto result = simplify(sphere, 2000);
  REQUIRE(result);
  REQUIRE(check_mesh(*result));
  CHECK(result->triangles.size() <= 2000);
  CHECK(result->triangles.size() > 1900);
  CHECK(result->positions.size() ==
        result->triangles.size() / 2 + 2);  // Euler, of a closed surface without holes
  CHECK(signed_volume(*result) == doctest::Approx(signed_volume(sphere)).epsilon(0.01).scale(0));
}

TEST_CASE("a mesh that is small enough keeps its triangles and loses its unused vertices") {
  TriangleMesh mesh = cube();
  mesh.positions.insert(mesh.positions.begin(), Vec3f{9, 9, 9});
  for (Triangle& t : mesh.triangles)
    for (auto& vertex : t) ++vertex;
  const auto result = simplify(mesh, 12);
  REQUIRE(result);
  CHECK(same_bits(*result, cube()));
}

TEST_CASE("a target that the topology does not allow is an error with both numbers") {
  const auto result = simplify(cube(), 0);
  REQUIRE_FALSE(result);
  CHECK(result.error().message.find("The mesh of 12 triangles simplifies to ") == 0);
}

TEST_CASE("a non-manifold mesh simplifies") {
  TriangleMesh mesh = make_sphere(32, 32);
  const std::size_t count = mesh.triangles.size();
  mesh.positions.push_back({0, 0, 0});
  for (std::size_t i = 0; i < count; i += 50)  // fins from the surface to the centre
    mesh.triangles.push_back({mesh.triangles[i][0], mesh.triangles[i][1], 994});
  REQUIRE(check_mesh(mesh));
  const auto result = simplify(mesh, 1500);
  REQUIRE(result);
  CHECK(check_mesh(*result));
  CHECK(result->triangles.size() <= 1500);
}
