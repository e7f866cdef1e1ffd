#include <doctest/doctest.h>

#include <map>

#include "mesh/primitives.hpp"
#include "model/assets.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

/// A tetrahedron of side 1 with one triangle more, which has no area in it; the others are where `meshes`
/// calls.
mesh::TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}},
          {{0, 2, 1}, {0, 1, 4}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

Result<mesh::TriangleMesh> read(const std::string& name) {
  mesh::TriangleMesh mesh = tetrahedron();
  if (name == "bent.obj") mesh.positions[4] = {2, -1, 0};  // now all five have an area
  if (name == "flat.obj") mesh.positions[3] = {0.25F, 0.25F, 0};
  if (name == "more.obj") mesh.positions.push_back({5, 5, 5});
  if (name == "turned.obj") std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
  if (name == "fewer.obj") mesh.triangles.pop_back();
  if (name == "apart.obj" ||
      name == "opened.obj") {  // another vertex at the first, which only the last triangle names
    mesh.positions.push_back({0, 0, name == "opened.obj" ? -1.0F : 0});
    mesh.triangles[4][0] = 5;
  }
  if (name == "line.obj")
    for (Vec3f& p : mesh.positions) p = {p.x, 0, 0};
  return mesh;
}

Result<Assets> assets_of(const std::string& colliders) {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "cloths": [{"grid": [4, 3], "size": [3, 2], "density": 0.2}],
          "contact": {"method": "proximity"}, "colliders": [)" +
          colliders + "]}",
      "a.json");
  if (!scene) FAIL(scene.error().message);
  return load_assets(*scene, read);
}

std::string refusal(const std::string& keyframe) {
  const auto assets = assets_of(
      R"({"kind": "mesh", "mesh": "a.obj", "keyframes": [{"time": 1, "mesh": "a.obj"}, {"time": 2, "mesh": ")" +
      keyframe + "\"}]}");
  REQUIRE_FALSE(assets);
  CHECK(assets.error().kind == ErrorKind::Input);
  return assets.error().message;
}

}  // namespace

TEST_CASE("meshes and boxes become objects in the order of the colliders, which they name") {
  const auto assets = assets_of(R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1},
    {"kind": "box", "center": [10, 0, 0], "size": [2, 4, 6], "rotate": [0, 0, 0.7071067811865476, 0.7071067811865476]},
    {"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 1},
    {"kind": "mesh", "mesh": "a.obj", "transform": {"scale": 2, "translate": [0, 1, 0]}})");
  REQUIRE(assets);
  REQUIRE(assets->objects.size() == 2);
  CHECK(assets->object_colliders == std::vector<std::size_t>{1, 3});
  REQUIRE(assets->keyframes.size() == 2);
  CHECK((assets->keyframes[0].empty() && assets->keyframes[1].empty()));
  const mesh::Bounds box = mesh::bounds(assets->objects[0]);  // a quarter turn about z: 4 along x, 2 along y
  CHECK(length(box.low - Vec3f{8, -1, -3}) < 1e-5F);
  CHECK(length(box.high - Vec3f{12, 1, 3}) < 1e-5F);
  CHECK(mesh::signed_volume(assets->objects[0]) == doctest::Approx(48));
  CHECK(assets->objects[1].triangles.size() == 4);
  CHECK(assets->objects[1].positions[4] == Vec3f{4, 1, 0});
  CHECK(assets->dropped_triangles == 1);
}

TEST_CASE("a mesh is read once, however many colliders and keyframes name it") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
          "cloths": [{"mesh": "b.obj", "density": 0.2}, {"mesh": "b.obj", "density": 0.2}],
          "contact": {"method": "proximity"}, "colliders": [
            {"kind": "mesh", "mesh": "a.obj"},
            {"kind": "mesh", "mesh": "a.obj", "transform": {"translate": [9, 0, 0]},
             "keyframes": [{"time": 1, "mesh": "bent.obj"}, {"time": 2, "mesh": "a.obj"},
                           {"time": 3, "mesh": "bent.obj"}]}]})",
      "a.json");
  if (!scene) FAIL(scene.error().message);
  std::map<std::string, int> reads;
  const auto assets = load_assets(*scene, [&](const std::string& name) {
    ++reads[name];
    return read(name);
  });
  if (!assets) FAIL(assets.error().message);
  CHECK(reads == std::map<std::string, int>{{"a.obj", 1}, {"b.obj", 1}, {"bent.obj", 1}});
  CHECK(assets->cloths[1].positions == tetrahedron().positions);
  CHECK(assets->objects[0].positions == tetrahedron().positions);
  REQUIRE(assets->keyframes[1].size() == 3);
  CHECK(assets->keyframes[1][1].positions == assets->objects[1].positions);
  CHECK(assets->keyframes[1][2].positions == assets->keyframes[1][0].positions);
}

TEST_CASE(
    "keyframes are placed as their mesh is, and have its triangles, whatever they make flat themselves") {
  const auto assets = assets_of(
      R"({"kind": "mesh", "mesh": "a.obj", "transform": {"scale": 2, "translate": [0, 1, 0]},
          "keyframes": [{"time": 1, "mesh": "bent.obj"}, {"time": 2, "mesh": "flat.obj"}]})");
  REQUIRE(assets);
  REQUIRE(assets->keyframes.at(0).size() == 2);
  CHECK(assets->dropped_triangles == 1);  // of the mesh, not of its keyframes
  for (const mesh::TriangleMesh& keyframe : assets->keyframes[0])
    CHECK(keyframe.triangles == assets->objects[0].triangles);
  CHECK(assets->keyframes[0][0].positions[4] == Vec3f{4, -1, 0});
  CHECK(assets->keyframes[0][1].positions[3] == Vec3f{0.5F, 1.5F, 0});
}

TEST_CASE("a keyframe of other vertices or other triangles is refused by its path and both meshes") {
  CHECK(refusal("more.obj") ==
        "a.json: colliders[0].keyframes[1]: mesh more.obj has 6 vertices, but a.obj has 5; a keyframe moves "
        "the same ones.");
  for (const std::string name : {"turned.obj", "fewer.obj"})
    CHECK(refusal(name) == "a.json: colliders[0].keyframes[1]: mesh " + name +
                               " has other triangles than a.obj; a keyframe moves the same ones.");
}

TEST_CASE("vertices of a collider at one place are one, unless a keyframe parts them") {
  const auto whole = assets_of(R"({"kind": "mesh", "mesh": "a.obj"})");
  const auto still =
      assets_of(R"({"kind": "mesh", "mesh": "apart.obj", "keyframes": [{"time": 1, "mesh": "apart.obj"}]})");
  REQUIRE((whole && still));
  CHECK(whole->merged_vertices == 0);
  CHECK(still->merged_vertices == 1);
  CHECK(still->objects[0].positions == whole->objects[0].positions);
  CHECK(still->objects[0].triangles == whole->objects[0].triangles);
  CHECK(still->keyframes[0][0].positions == whole->objects[0].positions);
  CHECK(still->keyframes[0][0].triangles == whole->objects[0].triangles);
  const auto opens =
      assets_of(R"({"kind": "mesh", "mesh": "apart.obj", "keyframes": [{"time": 1, "mesh": "opened.obj"}]})");
  REQUIRE(opens);
  CHECK(opens->merged_vertices == 0);
  CHECK(opens->objects[0].positions.size() == 6);
  CHECK(opens->keyframes[0][0].positions[5] == Vec3f{0, 0, -1});
}

TEST_CASE("a collider with no area is refused, a mesh by its name and a box by its path") {
  CHECK(assets_of(R"({"kind": "mesh", "mesh": "line.obj"})").error().message ==
        "a.json: colliders[0]: mesh line.obj has no triangle with an area.");
  CHECK(assets_of(R"({"kind": "box", "center": [1e6, 1e6, 1e6], "size": [1e-6, 1e-6, 1e-6]})")
            .error()
            .message == "a.json: colliders[0], a box, has no triangle with an area.");
}
