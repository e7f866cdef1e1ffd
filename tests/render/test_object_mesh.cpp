#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "mesh/primitives.hpp"
#include "render/floor.hpp"
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
  inputs.objects = {{open}, {mesh::make_sphere(5, 4)}};
  inputs.spheres = {{{1, 2, 3}, 0.5}};
  const ObjectMesh all = join_objects(inputs);
  const std::size_t fine = mesh::make_sphere(96, 48).triangles.size();
  CHECK(all.groups[0].index_count == 3 * (fine + 2 * 5 * 3));
  CHECK(all.indices.size() == all.groups[0].index_count + 3 * open.triangles.size());
  CHECK(all.positions.size() == all.normals.size());
  for (const std::uint32_t index : all.indices) CHECK(index < all.positions.size());
  CHECK(length(all.positions[0].xyz() - Vec3f{1, 2, 3}) == doctest::Approx(0.5));
  CHECK(join_objects({}).indices.empty());
}

TEST_CASE("a capsule is drawn around its axis, closed") {
  Inputs inputs;
  inputs.capsules = {{{1, 2, 3}, {3, 2, 1}, 0.5}};
  const ObjectMesh all = join_objects(inputs);
  CHECK(all.groups[0].index_count == all.indices.size());
  const Vec3f axis = Vec3f{2, 0, -2} / length(Vec3f{2, 0, -2});
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    const Vec3f from_a = all.positions[i].xyz() - Vec3f{1, 2, 3};
    const float along = std::min(std::max(dot(from_a, axis), 0.0F), std::sqrt(8.0F));
    CHECK(length(from_a - along * axis) == doctest::Approx(0.5).epsilon(1e-5).scale(0));
    CHECK(dot(all.normals[i].xyz(), from_a - along * axis) > 0.49F);
  }
}

TEST_CASE("a box is drawn with the normals of its faces, closed") {
  Inputs inputs;
  inputs.boxes = {{{5, 0, 0}, {2, 4, 6}}};
  const ObjectMesh all = join_objects(inputs);
  CHECK(all.groups[0].index_count == 36);
  CHECK(all.indices.size() == 36);
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    const Vec3f p = all.positions[i].xyz() - Vec3f{5, 0, 0}, n = all.normals[i].xyz();
    CHECK(std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == 1);
    CHECK(dot(n, p) == std::abs(n.x) + 2 * std::abs(n.y) + 3 * std::abs(n.z));
  }
}

TEST_CASE("what moves or deforms comes last, and its vertices have its number") {
  const scene::MotionLine line{{1, 0, 0}, 2};
  mesh::TriangleMesh bent = mesh::make_sphere(5, 4);
  Inputs inputs;
  inputs.spheres = {{{1, 2, 3}, 0.5, {}, line}};
  inputs.objects = {{bent, {{{1}}, {bent.positions}}}, {mesh::make_sphere(8, 6)}};
  const ObjectMesh all = join_objects(inputs);
  CHECK(all.groups[0].index_count == 3 * 2 * 8 * 5);
  CHECK(all.groups[1].index_count == 0);
  REQUIRE(all.moving.size() == 2);
  CHECK(all.moving[0].draw.motion == scene::ColliderMotion(line));
  CHECK(all.moving[1].draw.deformation.shapes.size() == 1);
  CHECK(all.moving[0].first_vertex == mesh::make_sphere(8, 6).positions.size());
  for (std::size_t m = 0; m < 2; ++m)
    for (std::size_t i = 0; i < all.moving[m].draw.mesh.positions.size(); ++i)
      CHECK(all.positions[all.moving[m].first_vertex + i] ==
            Vec4f::from(all.moving[m].draw.mesh.positions[i], static_cast<float>(m)));
  for (std::size_t i = 0; i < all.groups[0].index_count; ++i)
    CHECK(all.indices[i] < all.moving[0].first_vertex);
}

TEST_CASE("a mesh that turns inside out as it deforms is drawn from both sides") {
  mesh::TriangleMesh body = mesh::make_sphere(5, 4), mirrored = body;
  for (Vec3f& p : mirrored.positions) p.x = -p.x;
  Inputs inputs;
  inputs.objects = {{body, {{{1}}, {body.positions}}}, {body, {{{1}}, {mirrored.positions}}}};
  const ObjectMesh all = join_objects(inputs);
  CHECK(all.groups[2].index_count == 3 * body.triangles.size());
  CHECK(all.groups[3].index_count == 3 * body.triangles.size());
}

TEST_CASE("a plane that moves takes its squares along, and is seen below the same middle") {
  const PlaneParams rest = plane_params({{0, -1, 0}, {0, 1, 0}}, {0, 0, 0}, 24, false);
  CHECK(rest.along.w == 1);
  const scene::MotionLine line{{0.6, 0.8, 0}, 1};
  const PlaneParams moved = moved_plane(rest, scene::motion_at(scene::ColliderMotion(line), 8), {0, 0, 0});
  // 4.8 m aside: two pairs of squares and 0.8 m; 6.4 m up.
  CHECK(length(moved.center.xyz() - Vec3f{0.8F, 5.4F, 0}) < 1e-5F);
  CHECK(moved.along == rest.along);
  CHECK(moved.across == rest.across);
  const scene::MotionRotation turn{{1, 0, 0}, {0, -1, 0}, 1, 3.14159265358979};
  const PlaneParams over = moved_plane(rest, scene::motion_at(scene::ColliderMotion(turn), 9), {0, 0, 0});
  CHECK(length(over.center.xyz() - Vec3f{0, -1, 0}) < 1e-5F);
  CHECK(cross(over.along.xyz(), over.across.xyz()).y == doctest::Approx(-1));
}
