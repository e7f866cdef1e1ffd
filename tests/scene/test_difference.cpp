#include <doctest/doctest.h>

#include "scene/difference.hpp"
#include "scene/load.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

const std::string kScene = R"({"format": "weft-scene/1", "cloths": [
    {"mesh": "shirt.obj", "density": 1, "pins": [{"nodes": [1]}]},
    {"grid": [4, 3], "size": [3, 2], "density": 0.2, "pins": ["top_left"],
     "motions": [{"nodes": "top_right", "kind": "line", "direction": [1, 0, 0], "speed": 1}],
     "grabs": [{"node": "bottom_left", "path": [{"time": 0, "point": [0, 0, 0]}]}]}],
    "colliders": [{"kind": "mesh", "mesh": "dragon"}, {"kind": "sphere", "center": [0, 0, 0], "radius": 1}],
    "contact": {"method": "proximity"}})";

std::string difference(const std::string& key, const std::string& value, const std::string& scene = kScene) {
  const Override change[] = {{key, value}};
  const auto running = parse_scene(scene, "a.json"), wanted = parse_scene(scene, "b.json", change);
  if (!running) FAIL(running.error().message);
  if (!wanted) FAIL(wanted.error().message);
  return fixed_difference(*running, *wanted).value_or("none");
}

}  // namespace

TEST_CASE("the air, and what no state follows from, may differ in a running scene") {
  for (const auto& [key, value] : {std::pair{"gravity", "[0, -1.6, 0]"},
                                   {"external_force", "[1, 0, 0]"},
                                   {"drag", "3"},
                                   {"wind", R"({"velocity": [1, 0, 0], "gusts": 1})"},
                                   {"title", "\"other\""},
                                   {"description", "\"other\""},
                                   {"time.frames", "7"},
                                   {"render.view", "stretch"},
                                   {"camera", R"({"eye": [0, 0, 1], "target": [0, 0, 0]})"},
                                   {"render.light", R"({"environment": "sky", "degrees": 1})"},
                                   {"cloths[1].color", "[1, 0, 0]"},
                                   {"cloths[1].look", "\"silk\""},
                                   {"colliders[0].material", "metal"},
                                   {"colliders[1].material", "marble"},
                                   {"cloths[0].name", "\"other\""}}) {
    CAPTURE(key);
    CHECK(difference(key, value) == "none");
  }
}

TEST_CASE("a difference in anything else is found and named by its key") {
  for (const auto& [key, value] :
       {std::pair{"time.frame", "0.01"},
        {"time.substeps", "8"},
        {"solver.kind", "mass_spring"},
        {"solver.forces", "spring_centric"},
        {"contact.method", "none"},
        {"contact.thickness", "0.1"},
        {"contact.self", "false"},
        {"contact.restitution", "0.5"},
        {"air", "{}"},
        {"cloths[0].mesh", "\"coat.obj\""},
        {"cloths[1].grid", "[5, 3]"},
        {"cloths[1].size", "[3, 1]"},
        {"cloths[1].plane", "xz"},
        {"cloths[1].bump", "0.1"},
        {"cloths[1].transform", R"({"scale": 2})"},
        {"cloths[1].density", "0.3"},
        {"cloths[0].stiffness", R"({"bend": 1})"},
        {"cloths[1].fabric", R"({"warp": 9, "shear": 3, "bending_warp": 0})"},
        {"cloths[1].damping", "0.1"},
        {"cloths[1].friction", "0.1"},
        {"cloths[1].tethers", "{}"},
        {"cloths[1].pins", R"(["bottom_right"])"},
        {"cloths[1].motions", "[]"},
        {"cloths[1].grabs", "[]"},
        {"colliders", "[]"},
        {"colliders[0]", R"({"kind": "mesh", "mesh": "sphere"})"},
        {"colliders[1]", R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]})"}})
    CHECK(difference(key, value) == key);
  CHECK(difference("cloths[1].motions[0].speed", "2") == "cloths[1].motions");
  const auto swept = [](const char* iterations) {
    const Override change[] = {override_solver("xpbd"), {"solver.iterations", iterations}};
    return *parse_scene(kScene, "a.json", change);
  };
  CHECK(fixed_difference(swept("1"), swept("2")) == "solver.iterations");
  CHECK(difference("cloths[1].grabs[0].path[0].time", "2") == "cloths[1].grabs");
  CHECK(difference("colliders[1].friction", "0.1") == "colliders[1]");
  CHECK(difference("colliders[1].motion", R"({"kind": "line", "direction": [1, 0, 0], "speed": 1})") ==
        "colliders[1]");
  CHECK(difference("colliders[0].keyframes", R"([{"time": 1, "mesh": "a"}])") == "colliders[0]");
  CHECK(difference("cloths[0].pins[0].nodes", "[2]") == "cloths[0].pins");
  CHECK(difference("cloths[0].copies", R"({"count": 2, "offset": [0, 0, 1]})") == "cloths");
  CHECK(difference("cloths[0].copies", R"({"count": 1, "offset": [0, 0, 1]})") == "none");
}

TEST_CASE("a scene that is drawn coarser or finer is another: what it is drawn from is made at the start") {
  const Override change[] = {{"render.subdivide", "2"}};
  const auto running = parse_scene(minimal_scene(), "a.json"),
             wanted = parse_scene(minimal_scene(), "a.json", change);
  REQUIRE(running);
  REQUIRE(wanted);
  CHECK(fixed_difference(*running, *wanted) == "render.subdivide");
}

TEST_CASE("a difference in a body is found and named by its key") {
  const std::string bodies = R"({"format": "weft-scene/1", "bodies": [
      {"block": [1, 1, 1], "size": [1, 1, 1], "density": 1, "material": {"young": 1}},
      {"surface": "a.ply", "cell": 1, "density": 1, "material": {"young": 1}},
      {"tetrahedra": "a.msh", "density": 1, "material": {"young": 1}}]})";
  for (const auto& [key, value] : {std::pair{"bodies[0].block", "[1, 1, 2]"},
                                   {"bodies[0].size", "[1, 1, 2]"},
                                   {"bodies[0].density", "2"},
                                   {"bodies[0].material", R"({"young": 2})"},
                                   {"bodies[1].surface", "\"b.ply\""},
                                   {"bodies[1].cell", "2"},
                                   {"bodies[2].tetrahedra", "\"b.msh\""},
                                   {"bodies[2].friction", "2"}}) {
    CAPTURE(key);
    CHECK(difference(key, value, bodies) == key);
  }
}
