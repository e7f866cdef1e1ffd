#include <doctest/doctest.h>

#include <map>

#include "animated_box.hpp"
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
  REQUIRE(assets->deformations.size() == 2);
  CHECK((assets->deformations[0].empty() && assets->deformations[1].empty()));
  const mesh::Bounds box = mesh::bounds(assets->objects[0]);  // a quarter turn about z: 4 along x, 2 along y
  CHECK(length(box.low - Vec3f{8, -1, -3}) < 1e-5F);
  CHECK(length(box.high - Vec3f{12, 1, 3}) < 1e-5F);
  CHECK(mesh::signed_volume(assets->objects[0]) == doctest::Approx(48));
  CHECK(assets->objects[1].triangles.size() == 4);
  CHECK(assets->objects[1].positions[4] == Vec3f{4, 1, 0});
  CHECK(assets->dropped_triangles == 1);
}

TEST_CASE("a convex hull is an object: of a placed mesh's vertices or of points, once each") {
  const auto assets = assets_of(R"({"kind": "box", "center": [0, 0, 0], "size": [1, 1, 1]},
    {"kind": "convex", "mesh": "a.obj", "transform": {"scale": 2, "translate": [0, 1, 0]}},
    {"kind": "convex", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.1, 0.1, 0.1], [0.5, 0.5, 0]],
     "transform": {"scale": 3, "translate": [5, 0, 0]}})");
  REQUIRE_MESSAGE(assets, assets.error().message);
  REQUIRE(assets->objects.size() == 3);
  CHECK(assets->object_colliders == std::vector<std::size_t>{0, 1, 2});
  CHECK(assets->deformations.size() == 3);
  const mesh::TriangleMesh placed = mesh::transformed(tetrahedron(), 2, {0, 0, 0, 1}, {0, 1, 0});
  CHECK(mesh::bounds(assets->objects[1]).low == mesh::bounds(placed).low);
  CHECK(mesh::bounds(assets->objects[1]).high == mesh::bounds(placed).high);
  CHECK(assets->objects[2].positions == std::vector<Vec3f>{{5, 0, 0}, {8, 0, 0}, {5, 3, 0}, {5, 0, 3}});
  CHECK(mesh::signed_volume(assets->objects[2]) == doctest::Approx(4.5));
}

TEST_CASE("points in a plane have no hull, and the message names the collider") {
  const auto assets = assets_of(
      R"({"kind": "convex", "points": [[0, 1, 0], [1, 1, 0], [0, 1, 1], [1, 1, 1], [0.3, 1, 0.2]]})");
  REQUIRE_FALSE(assets);
  CHECK(assets.error().kind == ErrorKind::Input);
  CHECK(assets.error().message.find("a.json: colliders[0]") != std::string::npos);
  CHECK(assets.error().message.find("The 5 points lie in a plane") != std::string::npos);
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
  REQUIRE(assets->deformations[1].shapes.size() == 3);
  CHECK(assets->deformations[1].shapes[1] == assets->objects[1].positions);
  CHECK(assets->deformations[1].shapes[2] == assets->deformations[1].shapes[0]);
}

TEST_CASE(
    "keyframes are placed as their mesh is, and have its triangles, whatever they make flat themselves") {
  const auto assets = assets_of(
      R"({"kind": "mesh", "mesh": "a.obj", "transform": {"scale": 2, "translate": [0, 1, 0]},
          "keyframes": [{"time": 1, "mesh": "bent.obj"}, {"time": 2, "mesh": "flat.obj"}]})");
  REQUIRE(assets);
  REQUIRE(assets->deformations.at(0).shapes.size() == 2);
  CHECK(assets->dropped_triangles == 0);  // the keyframes give the fifth triangle an area
  CHECK(assets->deformations[0].shapes[0][4] == Vec3f{4, -1, 0});
  CHECK(assets->deformations[0].shapes[1][3] == Vec3f{0.5F, 1.5F, 0});
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
  CHECK(still->deformations[0].shapes[0] == whole->objects[0].positions);
  const auto opens =
      assets_of(R"({"kind": "mesh", "mesh": "apart.obj", "keyframes": [{"time": 1, "mesh": "opened.obj"}]})");
  REQUIRE(opens);
  CHECK(opens->merged_vertices == 0);
  CHECK(opens->objects[0].positions.size() == 6);
  CHECK(opens->deformations[0].shapes[0][5] == Vec3f{0, 0, -1});
}

namespace {

/// A box that rises by 1 m in 0.5 s, and sinks again in 0.5 s more.
Result<Assets> animated(const std::string& animation, std::vector<float> heights = {0, 1, 0},
                        const std::string& more = "") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"grid": [4, 3], "size": [3, 2], "density": 0.2}],
          "colliders": [{"kind": "mesh", "mesh": "box.glb", "animation": )" +
          animation + more + "}]}",
      "a.json");
  if (!scene) return scene.error();
  return load_assets(*scene, read, [&](const std::string& name) {
    CHECK(name == "box.glb");
    return mesh::AnimatedMesh::read(animated_box({2, 2, 2}, {0, 0.5, 1}, heights));
  });
}

}  // namespace

TEST_CASE("an animation is taken as shapes, from where it starts, as fast as it is run, and begins anew") {
  const auto assets = animated(R"({"rate": 8})");
  REQUIRE_MESSAGE(assets, assets.error().message);
  const mesh::Deformation& round = assets->deformations.at(0);
  CHECK(round.times.loops);
  CHECK(round.times.times == std::vector<double>{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1});
  const double bottom = static_cast<double>(mesh::bounds(assets->objects[0]).low.y);
  const auto height = [&](const Assets& of, std::size_t shape) {
    return static_cast<double>(mesh::bounds({of.deformations[0].shapes[shape], {}}).low.y) - bottom;
  };
  CHECK(height(*assets, 1) == doctest::Approx(0.5));
  CHECK(height(*assets, 3) == doctest::Approx(1));
  CHECK(height(*assets, 6) == doctest::Approx(0.25));
  CHECK(round.shapes.back() == assets->objects[0].positions);

  const auto late = animated(R"({"name": "lift", "start": 0.25, "speed": 2, "rate": 8})");
  REQUIRE(late);
  CHECK(late->deformations[0].times.times == std::vector<double>{0.125, 0.25, 0.375, 0.5});
  CHECK(static_cast<double>(mesh::bounds(late->objects[0]).low.y) - bottom == doctest::Approx(0.5));
  CHECK(height(*late, 0) == doctest::Approx(1));
  CHECK(height(*late, 2) == doctest::Approx(0));

  // Its end is its end, however its time is rounded, and however short it is.
  for (const char* quick :
       {R"({"loop": false, "speed": 3.7})", R"({"loop": false, "speed": 1000, "rate": 1})"}) {
    const auto ended = animated(quick, {0, 1, 3});
    REQUIRE(ended);
    CHECK(static_cast<double>(mesh::bounds({ended->deformations[0].shapes.back(), {}}).low.y) - bottom == 3);
  }

  const auto once = animated(R"({"start": 0.25, "loop": false, "rate": 4})", {0, 1, 3});
  REQUIRE(once);
  CHECK_FALSE(once->deformations[0].times.loops);
  CHECK(once->deformations[0].times.times == std::vector<double>{0.25, 0.5, 0.75});
  CHECK(height(*once, 2) == doctest::Approx(3));
}

TEST_CASE("an animation that cannot be run is refused with what is wrong") {
  const auto refused = [](const Result<Assets>& assets) {
    return assets ? "is loaded" : assets.error().message;
  };
  CHECK(refused(animated("{}", {0, 1, 3})) ==
        "a.json: colliders[0].animation ends with a vertex 3 m from where it begins; it can be run with "
        "\"loop\": "
        "false.");
  CHECK(refused(animated(R"({"start": 1.5})")) ==
        "a.json: colliders[0].animation.start is 1.5 s, after the animation's end at 1 s.");
  CHECK(
      refused(animated(R"({"name": "jump"})")).find(R"(The file has no animation "jump"; it has "lift".)") !=
      std::string::npos);
  CHECK(refused(animated(R"({"speed": 0.001, "rate": 10000})"))
            .find("colliders[0].animation takes 9999990 shapes, which brings those of the scene to 89999910 "
                  "vertices, "
                  "nodes and joints, more than 16777216; a lower rate takes fewer.") != std::string::npos);
  // Also of two, of which each could be run alone.
  const std::string half = R"({"rate": 1e4, "speed": 0.01})";
  CHECK(refused(animated(half, {0, 1, 0}, R"(}, {"kind": "mesh", "mesh": "box.glb", "animation": )" + half))
            .find("colliders[1]") != std::string::npos);
  CHECK(refused(animated("{}", {0, 1, 0}, R"(, "keyframes": [{"time": 1, "mesh": "a.obj"}])")) ==
        "a.json: colliders[0] has keyframes and an animation; it deforms by one of them.");
  CHECK(refused(assets_of(R"({"kind": "mesh", "mesh": "a.obj", "animation": {}})"))
            .find("Mesh a.obj has no animation.") != std::string::npos);
}

TEST_CASE("a collider with no area is refused, a mesh by its name and a box by its path") {
  CHECK(assets_of(R"({"kind": "mesh", "mesh": "line.obj"})").error().message ==
        "a.json: colliders[0]: mesh line.obj has no triangle with an area.");
  CHECK(assets_of(R"({"kind": "box", "center": [1e6, 1e6, 1e6], "size": [1e-6, 1e-6, 1e-6]})")
            .error()
            .message == "a.json: colliders[0], a box, has no triangle with an area.");
}
