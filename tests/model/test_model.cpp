#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "model/model.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloths) {
  const auto scene =
      scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [)" + cloths + "]}", "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(scene->cloths.size()));
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

}  // namespace

TEST_CASE("the mass of a grid is its density times its area, scaled with its transform") {
  const Model model =
      model_of(R"({"grid": [7, 12], "size": [2, 3], "density": 0.2, "transform": {"scale": 2}})");
  CHECK(std::accumulate(model.mass.begin(), model.mass.end(), 0.0) == doctest::Approx(0.2 * 4 * 6));
  CHECK(model.mass[0] * 4 ==
        doctest::Approx(model.mass[8]));  // a corner has a quarter of an inner node's area
  CHECK(model.bodies[0].grid->width == 4);
  const auto springs = model.springs();
  CHECK(springs[0].rest_length == doctest::Approx(4.0 / 6));
}

TEST_CASE("with a node mass every node weighs the same and every spring counts in full") {
  const Model model = model_of(R"({"grid": [4, 5], "size": [1, 1], "node_mass": 0.3})");
  for (const double mass : model.mass) CHECK(mass == 0.3);
  for (const Spring spring : model.springs())
    CHECK((spring.stiffness == 5000.0F || spring.stiffness == 2000.0F || spring.stiffness == 500.0F));
}

TEST_CASE("cloths are numbered through, and pins and motions point at their nodes") {
  const Model model = model_of(
      R"({"grid": [3, 3], "size": [1, 1], "density": 1, "pins": ["top_left"]},
         {"grid": [3, 4], "size": [1, 1], "density": 1, "pins": ["bottom"],
          "motions": [{"nodes": "top_right", "kind": "line", "direction": [1, 0, 0], "speed": 1}]})");
  CHECK(model.vertex_count() == 21);
  CHECK(model.bodies[1].first_vertex == 9);
  CHECK(model.bodies[1].first_triangle == 8);
  CHECK(model.motion[0] == 1);
  CHECK(model.motion[9 + 2] == 2);  // moved by motions[0]
  CHECK(model.motion[9 + 9] == 1);
  CHECK(model.inverse_mass(0) == 0);
  CHECK(model.inverse_mass(1) > 0);
  for (std::size_t t = 8; t < model.triangles.size(); ++t)
    for (const std::uint32_t vertex : model.triangles[t]) CHECK(vertex >= 9);
  for (const Spring spring : model.springs(model.bodies[1])) CHECK(spring.node_a >= 9);
}

TEST_CASE("elements of several cloths are numbered through, made once, and of a copy anew") {
  Model model = model_of(
      R"({"grid": [3, 3], "size": [1, 1], "density": 1, "stiffness": {"bending": 1e-3}},
         {"grid": [3, 4], "size": [1, 1], "density": 1})");
  const std::uint64_t counted = model.count(ElementKind::Spring);
  const ElementTable& all = model.elements(ElementKind::Spring);
  CHECK(all.size() == counted);
  CHECK(&model.elements(ElementKind::Spring) == &all);
  const ElementTable& second = model.elements(ElementKind::Spring, model.bodies[1]);
  CHECK(std::equal(second.nodes.begin(), second.nodes.end(),
                   all.nodes.end() - static_cast<long>(second.nodes.size())));
  CHECK(model.count(ElementKind::Triple) == 6);  // a row and a column each, of the first cloth alone
  CHECK(model.count(ElementKind::Tet) == 0);
  CHECK(&model.incidence(ElementKind::Spring, model.bodies[1]) ==
        &model.incidence(ElementKind::Spring, model.bodies[1]));
  CHECK(model.incidence(ElementKind::Spring, model.bodies[1]).row_count() == 12);
  CHECK(&model.colors(ElementKind::Spring) == &model.colors(ElementKind::Spring));
  CHECK(model.colors(ElementKind::Spring).elements.size() == counted);
  Model copy = model;
  copy.bodies[0].stiffness.structural = 7;
  CHECK(copy.springs()[0].stiffness == 3.5F);  // a boundary spring counts half
  CHECK(model.springs()[0].stiffness == 2500.0F);
}

TEST_CASE("cloth of fabric has a membrane for each triangle, hinges between them, and no springs") {
  const Model model = model_of(R"({"grid": [4, 3], "size": [3, 2], "density": 0.2,
      "transform": {"rotate": [0, 0.6, 0, 0.8]}, "fabric": {"warp": 9, "shear": 3, "bending_warp": 1}})");
  CHECK(model.count(ElementKind::Membrane) == 2 * 3 * 2);
  CHECK(model.count(ElementKind::Hinge) == 23 - 10);  // edges, without those of the rim
  CHECK(model.count(ElementKind::Spring) == 0);
  CHECK(model.count(ElementKind::Triple) == 0);
  const Vec3d along = model.rest_position[1] - model.rest_position[0];  // of i
  CHECK(length(cross(model.bodies[0].warp, along)) < 1e-12);
}

TEST_CASE("the warp of a mesh turns with it") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"mesh": "a.obj", "density": 1, "transform": {
        "rotate": [0, 0, 0.70710678118, 0.70710678118], "translate": [5, 5, 5]},
        "fabric": {"warp": 9, "shear": 3, "bending_warp": 1, "warp_direction": [0, 2, 0]}}]})",
      "test.json");
  REQUIRE(scene);
  mesh::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto model = build_model(*scene, {mesh});
  REQUIRE(model);
  CHECK(length(model->bodies[0].warp - Vec3d{-2, 0, 0}) < 1e-6);
}

TEST_CASE("fabric has no membrane of a triangle without area") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"mesh": "a.obj", "density": 1,
        "fabric": {"warp": 9, "shear": 3, "bending_warp": 1}}]})",
      "test.json");
  REQUIRE(scene);
  mesh::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}};
  mesh.triangles = {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}};
  const auto model = build_model(*scene, {mesh});
  REQUIRE_FALSE(model);
  CHECK(model.error().kind == ErrorKind::Input);
  CHECK(model.error().message.find("cloths[0].fabric: triangle 2 of the mesh has no area") !=
        std::string::npos);
}

TEST_CASE("a cloth vertex without area is bad input that names the cloth") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"mesh": "a.obj", "density": 1}]})", "test.json");
  REQUIRE(scene);
  mesh::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}};
  const auto model = build_model(*scene, {mesh});
  REQUIRE_FALSE(model);
  CHECK(model.error().kind == ErrorKind::Input);
  CHECK(model.error().message.find("cloths[0]") != std::string::npos);
}

TEST_CASE("a grab must mean exactly one free node, which no other grab has at the same time") {
  const auto refused = [](const std::string& more) {
    const auto scene = scene::parse_scene(
        R"({"format": "weft-scene/1", "cloths": [{"grid": [3, 3], "size": [1, 1], "density": 1,
           "pins": ["top_left"], "grabs": [)" +
            more + "]}]}",
        "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    const auto model = build_model(*scene, {{}});
    return model ? "node " + std::to_string(model->grabs.at(0).node) : model.error().message;
  };
  const std::string path = R"(, "path": [{"time": 0, "point": [0, 0, 0]}]})";
  CHECK(refused(R"({"node": "bottom_left")" + path) == "node 6");
  CHECK(refused(R"({"node": "bottom")" + path) ==
        "test.json: cloths[0].grabs[0].node selects 3 nodes; a grab holds exactly one.");
  CHECK(refused(R"({"node": "top_left")" + path) ==
        "test.json: cloths[0].grabs[0].node selects node 0, which is pinned; a grab holds a free node.");
  const std::string first = R"({"node": {"nodes": [4]}, "start": 1, "end": 2)" + path + ", ";
  CHECK(refused(first + R"({"node": {"nodes": [4]}, "start": 2)" + path) == "node 4");
  CHECK(refused(first + R"({"node": {"nodes": [4]})" + path) ==
        "test.json: cloths[0].grabs[1] holds node 4, which test.json: cloths[0].grabs[0] holds at the same "
        "time.");
}
