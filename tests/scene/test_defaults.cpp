#include <doctest/doctest.h>

#include "scene/load.hpp"
#include "scene/looks.hpp"
#include "scene/names.hpp"
#include "scene/select.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Scene parsed(const std::string& text) {
  auto scene = parse_scene(text, "a.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

}  // namespace

TEST_CASE("what a scene leaves out has the default of docs/scene.md") {
  const Scene scene = parsed(minimal_scene());
  CHECK(scene.title.empty());
  CHECK(scene.description.empty());
  CHECK(scene.gravity == Vec3d{0, -9.81, 0});
  CHECK(scene.external_force == Vec3d{0, 0, 0});
  CHECK(scene.drag == 0);
  CHECK(scene.wind.velocity == Vec3d{0, 0, 0});
  CHECK(scene.wind.gusts == 0);
  CHECK(scene.wind.wavelength == 1);
  CHECK_FALSE(scene.air);
  CHECK(scene.time.frame == 1.0 / 60.0);
  CHECK_FALSE(scene.time.substeps);
  CHECK(scene.time.frames == 90);
  CHECK(scene.solver.kind == SolverKind::Auto);
  CHECK(scene.solver.forces == Forces::NodeCentric);
  CHECK(scene.contact.method == ContactMethod::Proximity);
  CHECK(scene.contact.thickness == 0.005);
  CHECK(scene.contact.self);
  CHECK(scene.contact.restitution == 0);
  CHECK(scene.colliders.empty());
  CHECK_FALSE(scene.camera);
  CHECK(scene.render.view == View::Textured);
  CHECK(scene.render.width == 1280);
  CHECK(scene.render.height == 720);
  CHECK(scene.render.subdivide == 0);
  CHECK(scene.render.light.environment == Environment::Studio);
  CHECK_FALSE(scene.render.light.direction);
  CHECK(scene.render.light.degrees == 3);

  const Cloth& cloth = scene.cloths.at(0);
  CHECK(cloth.name.empty());
  CHECK(cloth.grid->plane == Plane::Xy);
  CHECK(cloth.transform.scale == 1);
  CHECK(cloth.transform.rotate == std::array<double, 4>{0, 0, 0, 1});
  CHECK(cloth.transform.translate == Vec3d{0, 0, 0});
  CHECK(cloth.stiffness.structural == 5000);
  CHECK(cloth.stiffness.shear == 2000);
  CHECK(cloth.stiffness.bend == 500);
  CHECK(cloth.damping == 0.25);
  CHECK(cloth.friction == 0.3);
  CHECK(cloth.pins.empty());
  CHECK(cloth.motions.empty());
  CHECK(cloth.grabs.empty());
  CHECK(scene.cloths.size() == 1);
  CHECK(cloth.copy == 0);
  CHECK_FALSE(cloth.color);
  CHECK(cloth.look == Look{});
  CHECK(cloth.look == look_of("woven"));
  CHECK_FALSE(cloth.node_mass);
}

TEST_CASE("what a scene's air leaves out is that of a plate at sea level") {
  const Scene scene = parsed(R"({"format": "weft-scene/1", "air": {"lift": 2},
      "cloths": [{"grid": [3, 3], "size": [1, 1], "density": 1}]})");
  CHECK(scene.air == Air{1.225, 1.17, 2, 0.01});
  CHECK(Air{}.lift == 1.48);
}

TEST_CASE("what a pressure leaves out is that of an ideal gas at sea level") {
  const Scene scene = parsed(R"({"format": "weft-scene/1",
      "cloths": [{"mesh": "sphere", "density": 1, "pressure": {"gauge": 300}}]})");
  CHECK(scene.cloths[0].pressure == Pressure{300, 101325, GasLaw::Isothermal});
}

TEST_CASE("what a fabric leaves out follows from the rest of it") {
  const Scene scene = parsed(
      R"({"format": "weft-scene/1", "cloths": [{"grid": [3, 3], "size": [1, 1], "density": 1,
          "fabric": {"warp": 100, "shear": 30, "bending_warp": 4}},
        {"grid": [3, 3], "size": [1, 1], "density": 1,
          "fabric": {"warp": 100, "weft": 50, "shear": 30, "bending_warp": 4, "bending_weft": 9,
            "energy": "green"}}]})");
  const Fabric &plain = *scene.cloths.at(0).fabric, &woven = *scene.cloths.at(1).fabric;
  CHECK(plain.weft == 100);
  CHECK(plain.poisson == 0);
  CHECK(plain.bending_weft == 4);
  CHECK(plain.bending_twist == 2);
  CHECK(plain.damping == Fabric{}.damping);
  CHECK(plain.energy == FabricEnergy::Yarn);
  CHECK(plain.warp_direction == Vec3d{1, 0, 0});
  CHECK(plain.rest_angles == scene::RestAngles::Mesh);
  CHECK(woven.weft == 50);
  CHECK(woven.bending_weft == 9);
  CHECK(woven.bending_twist == 3);
  CHECK(woven.energy == FabricEnergy::Green);
}

TEST_CASE("a default-made Scene has the same defaults as one that is read") {
  const Scene made, read = parsed(minimal_scene());
  CHECK(made.gravity == read.gravity);
  CHECK(made.wind.gusts == read.wind.gusts);
  CHECK(made.wind.wavelength == read.wind.wavelength);
  CHECK(made.time.frame == read.time.frame);
  CHECK(made.time.substeps == read.time.substeps);
  CHECK(made.time.frames == read.time.frames);
  CHECK(made.solver.forces == read.solver.forces);
  CHECK(made.contact.method == read.contact.method);
  CHECK(made.contact.thickness == read.contact.thickness);
  CHECK(made.contact.self == read.contact.self);
  CHECK(made.contact.restitution == read.contact.restitution);
  CHECK(made.render.view == read.render.view);
  CHECK(made.render.width == read.render.width);
  CHECK(Cloth{}.stiffness.structural == read.cloths[0].stiffness.structural);
  CHECK(Cloth{}.stiffness.shear == read.cloths[0].stiffness.shear);
  CHECK(Cloth{}.stiffness.bend == read.cloths[0].stiffness.bend);
  CHECK(Cloth{}.stiffness.bending == read.cloths[0].stiffness.bending);
  CHECK(Cloth{}.damping == read.cloths[0].damping);
  CHECK(Cloth{}.friction == read.cloths[0].friction);
  CHECK(Camera{}.fov_degrees == 35);
}

TEST_CASE("every key arrives where it belongs") {
  const Scene scene = parsed(R"({
    "format": "weft-scene/1", "title": "T", "description": "D", "gravity": [1, 2, 3], "external_force": [4, 5, 6],
    "drag": 0.5, "wind": {"velocity": [7, 8, 9], "gusts": 0.25, "wavelength": 3},
    "air": {"density": 2, "pressure": 3, "lift": 4, "friction": 5},
    "time": {"frame": 0.02, "substeps": 12, "frames": 7},
    "solver": {"kind": "mass_spring", "forces": "spring_centric"},
    "contact": {"method": "proximity", "thickness": 0.01, "self": false, "restitution": 0.5},
    "cloths": [
      {"name": "flag", "grid": [5, 3], "size": [4, 2], "plane": "xz", "bump": 0.02, "node_mass": 0.1, "damping": 2,
      "friction": 0.7,
       "transform": {"scale": 2, "rotate": [0, 0, 0.6, 0.8], "translate": [1, 2, 3]},
       "stiffness": {"structural": 1, "shear": 2, "bend": 3}, "color": [0.1, 0.2, 0.3],
       "pins": ["top_left", {"box": {"min": [0, 1, 2], "max": [3, 4, 5]}}, {"nodes": [7, 8]},
                {"near": {"point": [1, 2, 3], "radius": 0.5}}],
       "motions": [
         {"nodes": "right", "kind": "line", "direction": [0, 3, 4], "speed": 2, "distance": 5, "start": 1, "ramp": 0.5},
         {"nodes": ["left", {"nodes": [1]}], "kind": "path", "points": [[1, [0, 0, 1]], [2, [0, 1, 0]]]},
         {"nodes": {"nodes": [3]}, "kind": "rotation", "axis": [0, 0, 2], "center": [1, 1, 1], "speed": 3, "angle": 6,
          "start": 2, "ramp": 1}],
       "grabs": [{"node": {"nodes": [6]}, "start": 1, "end": 2, "path": [{"time": 1.5, "point": [1, 2, 3]}]}]},
      {"mesh": "shirt.obj", "density": 0.3}],
    "colliders": [{"kind": "mesh", "mesh": "dragon", "transform": {"scale": 0.5}, "friction": 0.1,
                   "keyframes": [{"time": 0.5, "mesh": "a.obj"}, {"time": 1, "mesh": "b.obj"}]},
                  {"kind": "sphere", "center": [1, 2, 3], "radius": 4, "friction": 0,
                   "motion": {"kind": "line", "direction": [0, 3, 4], "speed": 2, "distance": 5}},
                  {"kind": "plane", "point": [0, -1, 0], "normal": [0, 5, 0], "friction": 100,
                   "motion": {"kind": "path", "points": [[1, [0, 0, 1]]]}},
                  {"kind": "capsule", "a": [1, 2, 3], "b": [4, 5, 6], "radius": 0.5, "friction": 0.2,
                   "motion": {"kind": "rotation", "axis": [0, 0, 2], "center": [1, 1, 1], "speed": 3}},
                  {"kind": "box", "center": [1, 2, 3], "size": [4, 5, 6], "rotate": [0, 0, 0.6, 0.8], "friction": 0.4,
                   "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 1}}],
    "camera": {"eye": [0, 0, 5], "target": [0, 1, 0], "fov_degrees": 50},
    "render": {"view": "stretch", "size": [640, 480]}})");
  CHECK(scene.file == "a.json");
  CHECK(scene.title == "T");
  CHECK(scene.description == "D");
  CHECK(scene.gravity == Vec3d{1, 2, 3});
  CHECK(scene.external_force == Vec3d{4, 5, 6});
  CHECK(scene.drag == 0.5);
  CHECK(scene.wind.velocity == Vec3d{7, 8, 9});
  CHECK(scene.air == Air{2, 3, 4, 5});
  CHECK(scene.wind.gusts == 0.25);
  CHECK(scene.wind.wavelength == 3);
  CHECK(scene.time.frame == 0.02);
  CHECK(scene.time.substeps == 12U);
  CHECK(scene.time.frames == 7);
  CHECK(scene.solver.forces == Forces::SpringCentric);
  CHECK(scene.contact.method == ContactMethod::Proximity);
  CHECK(scene.contact.thickness == 0.01);
  CHECK_FALSE(scene.contact.self);
  CHECK(scene.contact.restitution == 0.5);
  CHECK(scene.camera->eye == Vec3d{0, 0, 5});
  CHECK(scene.camera->target == Vec3d{0, 1, 0});
  CHECK(scene.camera->fov_degrees == 50);
  CHECK(scene.render.view == View::Stretch);
  CHECK(scene.render.width == 640);
  CHECK(scene.render.height == 480);

  REQUIRE(scene.cloths.size() == 2);
  const Cloth& flag = scene.cloths[0];
  CHECK(flag.name == "flag");
  CHECK(flag.grid->nx == 5);
  CHECK(flag.grid->ny == 3);
  CHECK(flag.grid->width == 4);
  CHECK(flag.grid->height == 2);
  CHECK(flag.grid->plane == Plane::Xz);
  CHECK(flag.grid->bump == 0.02);
  CHECK(flag.node_mass == 0.1);
  CHECK_FALSE(flag.density);
  CHECK(flag.damping == 2);
  CHECK(flag.friction == 0.7);
  CHECK(flag.stiffness.bend == 3);
  CHECK(flag.color == Vec3d{0.1, 0.2, 0.3});
  CHECK(flag.transform.scale == 2);
  CHECK(flag.transform.rotate[3] == doctest::Approx(0.8));
  CHECK(flag.transform.translate == Vec3d{1, 2, 3});
  REQUIRE(flag.grabs.size() == 1);
  CHECK(flag.grabs[0].where == "a.json: cloths[0].grabs[0]");
  CHECK(flag.grabs[0].node.where == "a.json: cloths[0].grabs[0].node");
  CHECK(flag.grabs[0].start == 1);
  CHECK(flag.grabs[0].end == 2.0);
  CHECK(flag.grabs[0].path[0].time == 1.5);
  CHECK(flag.grabs[0].path[0].point == Vec3d{1, 2, 3});
  REQUIRE(flag.pins.size() == 4);
  CHECK(std::get<GridPart>(flag.pins[0].what) == GridPart::TopLeft);
  CHECK(std::get<SelectorBox>(flag.pins[1].what).max == Vec3d{3, 4, 5});
  CHECK(std::get<SelectorNodes>(flag.pins[2].what).indices == std::vector<std::uint32_t>{7, 8});
  CHECK(std::get<SelectorNear>(flag.pins[3].what).radius == 0.5);
  CHECK(flag.pins[3].where == "a.json: cloths[0].pins[3]");
  REQUIRE(flag.motions.size() == 3);
  const auto& line = std::get<MotionLine>(flag.motions[0].shape);
  CHECK(line.direction.y == doctest::Approx(0.6));
  CHECK(line.direction.z == doctest::Approx(0.8));
  CHECK(line.distance == 5.0);
  CHECK(line.start == 1);
  CHECK(line.ramp == 0.5);
  CHECK(flag.motions[1].nodes.size() == 2);
  CHECK(flag.motions[1].nodes[1].where == "a.json: cloths[0].motions[1].nodes[1]");
  CHECK(std::get<MotionPath>(flag.motions[1].shape).points[1].offset == Vec3d{0, 1, 0});
  CHECK(flag.motions[2].nodes[0].where == "a.json: cloths[0].motions[2].nodes");
  const auto& turn = std::get<MotionRotation>(flag.motions[2].shape);
  CHECK(turn.axis == Vec3d{0, 0, 1});
  CHECK(turn.angle == 6.0);
  CHECK(scene.cloths[1].mesh == "shirt.obj");
  CHECK(scene.cloths[1].density == 0.3);
  CHECK_FALSE(scene.cloths[1].grid);

  REQUIRE(scene.colliders.size() == 5);
  const auto& mesh = std::get<ColliderMesh>(scene.colliders[0]);
  CHECK(mesh.where == "a.json: colliders[0]");
  CHECK(mesh.mesh == "dragon");
  CHECK(mesh.transform.scale == 0.5);
  CHECK(mesh.keyframes == std::vector<ColliderKeyframe>{{0.5, "a.obj"}, {1, "b.obj"}});
  CHECK(std::get<ColliderSphere>(scene.colliders[1]).radius == 4);
  CHECK(std::get<ColliderPlane>(scene.colliders[2]).normal == Vec3d{0, 1, 0});
  const auto& capsule = std::get<ColliderCapsule>(scene.colliders[3]);
  CHECK(capsule.a == Vec3d{1, 2, 3});
  CHECK(capsule.b == Vec3d{4, 5, 6});
  CHECK(capsule.radius == 0.5);
  const auto& box = std::get<ColliderBox>(scene.colliders[4]);
  CHECK(box.center == Vec3d{1, 2, 3});
  CHECK(box.size == Vec3d{4, 5, 6});
  CHECK(box.rotate[3] == doctest::Approx(0.8));
  const double frictions[] = {0.1, 0, 100, 0.2, 0.4};
  for (std::size_t c = 0; c < 5; ++c) CHECK(friction_of(scene.colliders[c]) == frictions[c]);
  CHECK_FALSE(motion_of(scene.colliders[0]));
  CHECK(std::get<MotionLine>(*motion_of(scene.colliders[1])).distance == 5.0);
  CHECK(std::get<MotionPath>(*motion_of(scene.colliders[2])).points[0].offset == Vec3d{0, 0, 1});
  CHECK(std::get<MotionRotation>(*motion_of(scene.colliders[3])).axis == Vec3d{0, 0, 1});
  CHECK(std::get<MotionLine>(*motion_of(scene.colliders[4])).direction == Vec3d{1, 0, 0});
}

TEST_CASE("a collider gives no friction of its own, stays and has one shape unless it says so") {
  const Scene scene = parsed(scene_with(R"("colliders": [{"kind": "mesh", "mesh": "dragon"},
    {"kind": "sphere", "center": [0, 0, 0], "radius": 1}, {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]},
    {"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 1},
    {"kind": "box", "center": [0, 0, 0], "size": [1, 1, 1]}],
    "contact": {"method": "proximity"})"));
  for (const Collider& collider : scene.colliders) {
    CHECK_FALSE(friction_of(collider));
    CHECK_FALSE(motion_of(collider));
  }
  CHECK(std::get<ColliderMesh>(scene.colliders[0]).keyframes.empty());
  CHECK(std::get<ColliderBox>(scene.colliders[4]).rotate == std::array<double, 4>{0, 0, 0, 1});
}

TEST_CASE(
    "what moves, deforms or is a capsule is read where nothing meets it, and a box or a hull by every "
    "method") {
  for (const char* collider : {R"({"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 1})",
                               R"({"kind": "sphere", "center": [0, 0, 0], "radius": 1,
                                   "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 1}})",
                               R"({"kind": "mesh", "mesh": "a", "keyframes": [{"time": 1, "mesh": "b"}]})"})
    for (const char* method : {"none", "proximity"})
      CHECK(parse_scene(scene_with("\"colliders\": [" + std::string(collider) +
                                   "], \"contact\": {\"method\": \"" + method + "\"}"),
                        "a"));
  for (const char* method : {"none", "paper", "bvh", "proximity"}) {
    const Scene scene = parsed(scene_with(
        R"("colliders": [{"kind": "box", "center": [0, 0, 0], "size": [1, 2, 3]},
                         {"kind": "mesh", "mesh": "a", "keyframes": []},
                         {"kind": "convex", "mesh": "b", "transform": {"scale": 2}, "friction": 0.5},
                         {"kind": "convex", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}],
           "contact": {"method": ")" +
        std::string(method) + "\"}"));
    CHECK(std::get<ColliderBox>(scene.colliders[0]).size == Vec3d{1, 2, 3});
    const auto& of_mesh = std::get<ColliderConvex>(scene.colliders[2]);
    CHECK(of_mesh.where == "a.json: colliders[2]");
    CHECK((of_mesh.mesh == "b" && of_mesh.points.empty() && of_mesh.transform.scale == 2));
    CHECK(of_mesh.friction == 0.5);
    const auto& of_points = std::get<ColliderConvex>(scene.colliders[3]);
    CHECK((of_points.mesh.empty() && of_points.points.size() == 4));
    CHECK(of_points.points[2] == Vec3d{0, 1, 0});
    CHECK_FALSE(of_points == of_mesh);
  }
}

TEST_CASE("the word of each enumerator is the one that the scene says") {
  for (const char* word : {"textured", "wireframe", "normals", "stretch"})
    CHECK(std::string(name_of(
              parsed(scene_with("\"render\": {\"view\": \"" + std::string(word) + "\"}")).render.view)) ==
          word);
  for (const char* word : {"none", "paper", "bvh", "proximity"})
    CHECK(std::string(name_of(parsed(scene_with("\"contact\": {\"method\": \"" + std::string(word) + "\"}"))
                                  .contact.method)) == word);
  for (const char* word : {"node_centric", "spring_centric"})
    CHECK(std::string(name_of(
              parsed(scene_with("\"solver\": {\"forces\": \"" + std::string(word) + "\"}")).solver.forces)) ==
          word);
  for (const char* word : kSolverKindNames)
    CHECK(std::string(name_of(
              parsed(scene_with("\"solver\": {\"kind\": \"" + std::string(word) + "\"}")).solver.kind)) ==
          word);
  CHECK(std::string(name_of(Plane::Xz)) == "xz");
  CHECK(std::string(name_of(GridPart::Edges)) == "edges");
}

TEST_CASE("limits themselves are accepted") {
  CHECK(parse_scene(scene_with(R"("time": {"substeps": 65536, "frame": 10, "frames": 10000000})"), "a"));
  CHECK(parse_scene(scene_with(R"("time": {"substeps": 1.0, "frame": 1e-6, "frames": 1})"), "a"));
  CHECK(parse_scene(cloth_of(R"("grid": [2, 16384], "size": [1e-6, 1e6], "density": 1e-6)"), "a"));
  CHECK(parse_scene(cloth_of(R"("grid": [8192, 8192], "size": [1, 1], "node_mass": 1e-12)"), "a"));
  CHECK(parse_scene(cloth_with(R"("stiffness": {"structural": 0, "shear": 0, "bend": 1e12}, "damping": 0)"),
                    "a"));
  CHECK(parse_scene(scene_with(R"("contact": {"method": "bvh", "thickness": 0}, "drag": 10000)"), "a"));
}

TEST_CASE("quaternions within a thousandth of unit length are made unit, directions of any length too") {
  const Scene scene = parsed(cloth_with(R"("transform": {"rotate": [0.5, 0.5, 0.5, 0.501]})"));
  double sum = 0;
  for (const double q : scene.cloths[0].transform.rotate) sum += q * q;
  CHECK(sum == doctest::Approx(1).epsilon(1e-15).scale(0));
  for (const char* length : {"1e-320", "1e-200", "3", "1e6"}) {
    const std::string text =
        std::string("\"kind\": \"line\", \"speed\": 1, \"direction\": [0, -") + length + ", 0]";
    CHECK(std::get<MotionLine>(parsed(motion_with(text)).cloths[0].motions[0].shape).direction ==
          Vec3d{0, -1, 0});
  }
}

TEST_CASE("a transform scales, then rotates, then translates") {
  const double half = std::sqrt(0.5);
  const Transform quarter_about_z{2, {0, 0, half, half}, {10, 0, 0}};
  const Vec3d p = transformed(quarter_about_z, {1, 0, 0});  // (2, 0, 0), (0, 2, 0), (10, 2, 0)
  CHECK(length(p - Vec3d{10, 2, 0}) < 1e-14);
  const Vec3d q = transformed({1, {0.5, 0.5, 0.5, 0.5}, {}}, {1, 2, 3});  // x -> y -> z -> x
  CHECK(length(q - Vec3d{3, 1, 2}) < 1e-14);
}
