#include <doctest/doctest.h>

#include "mesh/primitives.hpp"
#include "render/object_mesh.hpp"

using namespace weft;
using namespace weft::render;

TEST_CASE("a sphere's normals point away from its middle") {
  const mesh::TriangleMesh sphere = mesh::make_sphere(24, 16);
  const auto normals = vertex_normals(sphere);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    CHECK(length(normals[i]) == doctest::Approx(1));
    CHECK(dot(normals[i], sphere.positions[i]) > 0.99F);
  }
}

TEST_CASE("a larger triangle counts for more in a normal") {
  //   vertex 0 belongs to a triangle of area 1/2 that faces z and to one of area 2 that faces x
  const mesh::TriangleMesh bent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 0, 2}},
                                {{0, 1, 2}, {0, 3, 4}}};
  const Vec3f n = vertex_normals(bent)[0];
  CHECK(n.x / n.z == doctest::Approx(4));
}

TEST_CASE("closed is what has two triangles at each edge and faces outward") {
  mesh::TriangleMesh sphere = mesh::make_sphere(8, 6);
  CHECK(is_closed(sphere));
  mesh::TriangleMesh inward = sphere;
  for (mesh::Triangle& t : inward.triangles) std::swap(t[1], t[2]);
  CHECK_FALSE(is_closed(inward));
  mesh::TriangleMesh mixed = sphere;
  std::swap(mixed.triangles[3][1], mixed.triangles[3][2]);
  CHECK_FALSE(is_closed(mixed));
  sphere.triangles.pop_back();
  CHECK_FALSE(is_closed(sphere));
}

TEST_CASE("joined objects begin with the closed ones and keep every triangle") {
  mesh::TriangleMesh open = mesh::make_sphere(8, 6);
  open.triangles.pop_back();
  Inputs inputs;
  inputs.objects = {open, mesh::make_sphere(5, 4)};
  inputs.spheres = {{{1, 2, 3}, 0.5}};
  const ObjectMesh all = join_objects(inputs);
  const std::size_t fine = mesh::make_sphere(96, 48).triangles.size();
  CHECK(all.closed_index_count == 3 * (fine + 2 * 5 * 3));
  CHECK(all.indices.size() == all.closed_index_count + 3 * open.triangles.size());
  CHECK(all.positions.size() == all.normals.size());
  for (const std::uint32_t index : all.indices) CHECK(index < all.positions.size());
  CHECK(length(all.positions[0].xyz() - Vec3f{1, 2, 3}) == doctest::Approx(0.5));
  CHECK(join_objects({}).indices.empty());
}
