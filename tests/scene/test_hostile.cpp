#include <doctest/doctest.h>

#include "hostile.hpp"
#include "scene/load.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace weft::scene {

std::vector<Hostile> hostile_scenes() {
  const std::string good = minimal_scene();
  return {
      // The whole.
      {"[]", "the scene is a list of 0, not an object"},
      {"null", "the scene is null, not an object"},
      {"{}", R"(format is missing; it must be "weft-scene/1")"},
      {R"({"format": "weft-scene/1"})", "cloths is missing; it must be a list"},
      {R"({"format": "weft-scene/2", "cloths": []})", R"(format is "weft-scene/2", not "weft-scene/1")"},
      {R"({"format": "weft-scene/2", "sheets": []})", R"(format is "weft-scene/2", not "weft-scene/1")"},
      {R"({"format": 1, "cloths": []})", R"(format is 1, not "weft-scene/1")"},
      {R"({"format": "weft-scene/1", "cloths": []})", "cloths has 0 entries; it must have from 1 to 1000"},
      {R"({"format": "weft-scene/1", "cloths": [5]})", "cloths[0] is 5, not an object"},
      {R"({"format": "weft-scene/1", "cloth": []})", R"(cloth is not known; did you mean "cloths"?)"},
      {scene_with(R"("title": "")"), "title has 0 characters; it must have from 1 to 200"},
      {scene_with(R"("title": ")" + std::string(201, 'x') + "\""), "title has 201 characters"},
      {scene_with(R"("title": ["a"])"), "title is a list of 1, not a text"},
      {scene_with(R"("description": 3)"), "description is 3, not a text"},
      {scene_with(R"("description": ")" + std::string(10001, 'x') + "\""),
       "description has 10001 characters"},
      // Numbers of the whole.
      {scene_with(R"("gravity": -9.81)"), "gravity is -9.81, not a list of 3 numbers"},
      {scene_with(R"("gravity": [0, -9.81])"), "gravity is a list of 2, not a list of 3 numbers"},
      {scene_with(R"("gravity": [0, "-9.81", 0])"), R"(gravity[1] is the text "-9.81", not a number)"},
      {scene_with(R"("gravity": [0, null, 0])"), "gravity[1] is null, not a number"},
      {scene_with(R"("gravity": [0, -10001, 0])"),
       "gravity[1] is -10001; it must be from -10000 to 10000 m/s²"},
      {scene_with(R"("external_force": [1e5, 0, 0])"),
       "external_force[0] is 100000; it must be from -10000 to 10000 N/kg"},
      {scene_with(R"("drag": -0.5)"), "drag is -0.5; it must be from 0 to 10000 1/s"},
      {scene_with(R"("drag": true)"), "drag is true, not a number"},
      {scene_with(R"("wind": [1, 0, 0])"), R"(wind is not known; the keys here are "format", "title")"},
      {scene_with(R"("Gravity": [0, 0, 0])"), R"(Gravity is not known; did you mean "gravity"?)"},
      // time
      {scene_with(R"("time": 1)"), "time is 1, not an object"},
      {scene_with(R"("time": {"frame": 0})"), "time.frame is 0; it must be from 1e-06 to 10 s"},
      {scene_with(R"("time": {"frame": 10.5})"), "time.frame is 10.5; it must be"},
      {scene_with(R"("time": {"substeps": 0})"), "time.substeps is 0; it must be from 1 to 65536"},
      {scene_with(R"("time": {"substeps": 65537})"), "time.substeps is 65537; it must be from 1 to 65536"},
      {scene_with(R"("time": {"substeps": 2.5})"), "time.substeps is 2.5, not a whole number"},
      {scene_with(R"("time": {"substeps": "atuo"})"),
       R"(time.substeps is "atuo", not "auto"; did you mean "auto"?)"},
      {scene_with(R"("time": {"substeps": []})"),
       R"(time.substeps is a list of 0, not a whole number, or "auto")"},
      {scene_with(R"("time": {"frames": 0})"), "time.frames is 0; it must be from 1 to 10000000"},
      {scene_with(R"("time": {"frames": 1e300})"), "time.frames is 1e+300; it must be"},
      {scene_with(R"("time": {"substep": 4})"), R"(time.substep is not known; did you mean "substeps"?)"},
      // solver, contact, camera, render
      {scene_with(R"("solver": "mass_spring")"), R"(solver is the text "mass_spring", not an object)"},
      {scene_with(R"("solver": {"kind": "xpbd"})"), R"(solver.kind is "xpbd", not "mass_spring")"},
      {scene_with(R"("solver": {"kind": 7})"), R"(solver.kind is 7, not "mass_spring")"},
      {scene_with(R"("solver": {"forces": "node-centric"})"), R"(did you mean "node_centric"?)"},
      {scene_with(R"("solver": {"iterations": 4})"),
       R"(solver.iterations is not known; the keys here are "kind", "forces")"},
      {scene_with(R"("contact": {"method": "bhv"})"),
       R"(contact.method is "bhv", not one of "none", "paper", "bvh"; did you mean "bvh"?)"},
      {scene_with(R"("contact": {"method": "proximity"})"), R"(contact.method is "proximity", not one of)"},
      {scene_with(R"("contact": {"thickness": -0.001})"),
       "contact.thickness is -0.001; it must be from 0 to 10 m"},
      {scene_with(R"("contact": {"thicknes": 0})"),
       R"(contact.thicknes is not known; did you mean "thickness"?)"},
      {scene_with(R"("camera": {"target": [0, 0, 0]})"),
       "camera.eye is missing; it must be a list of 3 numbers"},
      {scene_with(R"("camera": {"eye": [0, 0, 0]})"), "camera.target is missing"},
      {scene_with(R"("camera": {"eye": [0, 0, 1], "target": [0, 0, 1]})"), "camera.target is the eye itself",
       false},
      {scene_with(R"("camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fov_degrees": 180})"),
       "camera.fov_degrees is 180; it must be from 1 to 170 °"},
      {scene_with(R"("camera": {"eye": [0, 0, 1], "target": [0, 0, 0], "fov": 35})"),
       "camera.fov is not known"},
      {scene_with(R"("render": {"view": "textures"})"), R"(did you mean "textured"?)"},
      {scene_with(R"("render": {"size": [1280, 15]})"),
       "render.size[1] is 15; it must be from 16 to 16384 pixels"},
      {scene_with(R"("render": {"size": [1280.5, 720]})"), "render.size[0] is 1280.5, not a whole number"},
      {scene_with(R"("render": {"sise": [1280, 720]})"), R"(render.sise is not known; did you mean "size"?)"},
      // A cloth's shape and mass.
      {cloth_of(R"("density": 0.2)"), R"(cloths[0] has neither "grid" nor "mesh"; it must have one of them)"},
      {cloth_of(R"("grid": [4, 3], "size": [3, 2], "mesh": "shirt", "density": 0.2)"),
       R"(cloths[0] has both "grid" and "mesh"; it must have one of them)"},
      {cloth_of(R"("grid": [4, 3], "size": [3, 2])"), R"(cloths[0] has neither "density" nor "node_mass")"},
      {cloth_with(R"("node_mass": 1)"), R"(cloths[0] has both "density" and "node_mass")"},
      {cloth_of(R"("grid": [4, 3], "density": 0.2)"), R"(cloths[0].grid needs "size" beside it)"},
      {cloth_of(R"("mesh": "shirt", "size": [1, 1], "density": 0.2)"),
       R"(cloths[0].size needs "grid" beside it)"},
      {cloth_of(R"("mesh": "shirt", "plane": "xy", "density": 0.2)"),
       R"(cloths[0].plane needs "grid" beside it)"},
      {cloth_of(R"("mesh": "", "density": 0.2)"), "cloths[0].mesh has 0 characters"},
      {cloth_of(R"("mesh": 4, "density": 0.2)"), "cloths[0].mesh is 4, not a text"},
      {cloth_of(R"("grid": [1, 3], "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid[0] is 1; it must be from 2 to 16384"},
      {cloth_of(R"("grid": [4, 16385], "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid[1] is 16385; it must be"},
      {cloth_of(R"("grid": [4.5, 3], "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid[0] is 4.5, not a whole number"},
      {cloth_of(R"("grid": [4], "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid is a list of 1, not a list of 2 numbers"},
      {cloth_of(R"("grid": 64, "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid is 64, not a list of 2 numbers"},
      {cloth_of(R"("grid": [16384, 8192], "size": [3, 2], "density": 0.2)"),
       "cloths[0].grid brings the grids to 134217728 nodes, more than the limit of 67108864", false},
      {R"({"format": "weft-scene/1", "cloths": [
          {"grid": [8192, 8192], "size": [3, 2], "density": 0.2}, {"grid": [2, 2], "size": [3, 2], "density": 0.2}]})",
       "cloths[1].grid brings the grids to 67108868 nodes", false},
      {cloth_of(R"("grid": [4, 3], "size": [0, 2], "density": 0.2)"),
       "cloths[0].size[0] is 0; it must be from 1e-06 to 1000000 m"},
      {cloth_of(R"("grid": [4, 3], "size": [3, -2], "density": 0.2)"), "cloths[0].size[1] is -2; it must be"},
      {cloth_of(R"("grid": [4, 3], "size": [3, 2], "density": 0)"),
       "cloths[0].density is 0; it must be from 1e-06 to 1000000 kg/m²"},
      {cloth_of(R"("grid": [4, 3], "size": [3, 2], "node_mass": -1)"),
       "cloths[0].node_mass is -1; it must be from 1e-12 to 1000000 kg"},
      {cloth_with(R"("plane": "yz")"), R"(cloths[0].plane is "yz", not one of "xy", "xz")"},
      {cloth_with(R"("name": 7)"), "cloths[0].name is 7, not a text"},
      // A cloth's transform, springs and colour.
      {cloth_with(R"("transform": {"scale": 0})"),
       "cloths[0].transform.scale is 0; it must be from 1e-06 to 1000000"},
      {cloth_with(R"("transform": {"rotate": [0, 0, 0, 0]})"),
       "cloths[0].transform.rotate has length 0; a unit quaternion", false},
      {cloth_with(R"("transform": {"rotate": [0, 0, 1, 0.1]})"),
       "cloths[0].transform.rotate has length 1.00498", false},
      {cloth_with(R"("transform": {"rotate": [0, 0, 2, 0]})"),
       "cloths[0].transform.rotate[2] is 2; it must be from -1.001 to 1.001"},
      {cloth_with(R"("transform": {"rotate": [0, 0, 1]})"), "rotate is a list of 3, not a list of 4 numbers"},
      {cloth_with(R"("transform": {"translate": [0, 1e7, 0]})"),
       "translate[1] is 10000000; it must be from -1000000 to 1000000 m"},
      {cloth_with(R"("transform": {"rotation": [0, 0, 0, 1]})"),
       R"(transform.rotation is not known; did you mean "rotate"?)"},
      {cloth_with(R"("stifness": {})"), R"(cloths[0].stifness is not known; did you mean "stiffness"?)"},
      {cloth_with(R"("stiffness": 5000)"), "cloths[0].stiffness is 5000, not an object"},
      {cloth_with(R"("stiffness": {"structural": -1})"),
       "cloths[0].stiffness.structural is -1; it must be from 0 to 1e+12 N/m"},
      {cloth_with(R"("stiffness": {"shear": "2000"})"),
       R"(cloths[0].stiffness.shear is the text "2000", not a number)"},
      {cloth_with(R"("stiffness": {"bend": 1e13})"), "cloths[0].stiffness.bend is 1e+13; it must be"},
      {cloth_with(R"("stiffness": {"bending": 1})"),
       R"(cloths[0].stiffness.bending is not known; did you mean "bend"?)"},
      {cloth_with(R"("damping": -0.25)"),
       "cloths[0].damping is -0.25; it must be from 0 to 1000000000 N·s/m"},
      {cloth_with(R"("friction": 0.3)"), "cloths[0].friction is not known"},
      {cloth_with(R"("color": [1, 0.5, 1.5])"), "cloths[0].color[2] is 1.5; it must be from 0 to 1"},
      {cloth_with(R"("color": "red")"), R"(cloths[0].color is the text "red", not a list of 3 numbers)"},
      // Selectors.
      {cloth_with(R"("pins": "top")"), R"(cloths[0].pins is the text "top", not a list)"},
      {cloth_with(R"("pins": ["topleft"])"), R"(did you mean "top_left"?)"},
      {cloth_with(R"("pins": [0])"), "cloths[0].pins[0] is 0, not one of"},
      {cloth_with(R"("pins": ["top", {}])"), R"(cloths[0].pins[1] has neither "box" nor "nodes" nor "near")"},
      {cloth_with(R"("pins": [{"nodes": [0], "near": {"point": [0, 0, 0], "radius": 1}}])"),
       R"(has both "nodes" and "near")"},
      {cloth_with(R"("pins": [{"box": {"min": [0, 0, 0]}}])"), "cloths[0].pins[0].box.max is missing"},
      {cloth_with(R"("pins": [{"box": {"min": [0, 1, 0], "max": [1, 0, 1]}}])"),
       "cloths[0].pins[0].box.max[1] is 0, below the box's min of 1", false},
      {cloth_with(R"("pins": [{"nodes": []}])"), "cloths[0].pins[0].nodes has 0 entries"},
      {cloth_with(R"("pins": [{"nodes": [0, -1]}])"),
       "cloths[0].pins[0].nodes[1] is -1; it must be from 0 to 67108863"},
      {cloth_with(R"("pins": [{"nodes": [1.5]}])"), "cloths[0].pins[0].nodes[0] is 1.5, not a whole number"},
      {cloth_with(R"("pins": [{"near": {"point": [0, 0, 0], "radius": 0}}])"),
       "near.radius is 0; it must be from 1e-06"},
      {cloth_with(R"("pins": [{"near": {"point": [0, 0, 0]}}])"),
       "near.radius is missing; it must be a number"},
      {cloth_of(R"("mesh": "shirt", "density": 0.2, "pins": ["top"])"),
       R"(cloths[0].pins[0] is "top", a part that only a grid has)", false},
      // Motions.
      {cloth_with(R"("motions": [{"nodes": "top"}])"),
       R"(cloths[0].motions[0].kind is missing; it must be one of "line", "path", "rotation")"},
      {cloth_with(R"("motions": [{"kind": "line", "direction": [1, 0, 0], "speed": 1}])"),
       "cloths[0].motions[0].nodes is missing"},
      {cloth_with(R"("motions": [{"kind": "line", "nodes": [], "direction": [1, 0, 0], "speed": 1}])"),
       "nodes has 0 entries"},
      {motion_with(R"("kind": "spiral")"),
       R"(cloths[0].motions[0].kind is "spiral", not one of "line", "path", "rotation")"},
      {motion_with(R"("kind": "line", "speed": 1)"), "cloths[0].motions[0].direction is missing"},
      {motion_with(R"("kind": "line", "direction": [0, 0, -0.0], "speed": 1)"),
       "direction is zero, and so has no direction"},
      {motion_with(R"("kind": "line", "direction": [1, 0, 0], "speed": 0)"),
       "speed is 0; it must be from 1e-09 to 10000 m/s"},
      {motion_with(R"("kind": "line", "direction": [1, 0, 0], "speed": 1, "distance": 0)"),
       "distance is 0; it must be"},
      {motion_with(R"("kind": "line", "direction": [1, 0, 0], "speed": 1, "start": -1)"),
       "start is -1; it must be from 0 to 1000000 s"},
      {motion_with(R"("kind": "line", "direction": [1, 0, 0], "speed": 1, "ramp": -1)"),
       "ramp is -1; it must be from 0 to 1000000 s"},
      {motion_with(R"("kind": "line", "direction": [1, 0, 0], "speed": 1, "angle": 1)"),
       "motions[0].angle is not known"},
      {motion_with(R"("kind": "path", "points": [])"), "points has 0 entries"},
      {motion_with(R"("kind": "path", "points": [[0]])"), "points[0] is a list of 1, not a list of 2"},
      {motion_with(R"("kind": "path", "points": [[0, [0, 0]]])"),
       "points[0][1] is a list of 2, not a list of 3 numbers"},
      {motion_with(R"("kind": "path", "points": [[-1, [0, 0, 0]]])"),
       "points[0][0] is -1; it must be from 0 to 1000000 s"},
      {motion_with(R"("kind": "path", "points": [[1, [0, 0, 0]], [1, [1, 0, 0]]])"),
       "cloths[0].motions[0].points[1][0] is 1 s, not after the 1 s of the point before it", false},
      {motion_with(R"("kind": "rotation", "axis": [0, 0, 0], "center": [0, 0, 0], "speed": 1)"),
       "axis is zero"},
      {motion_with(R"("kind": "rotation", "axis": [0, 1, 0], "speed": 1)"), "center is missing"},
      {motion_with(R"("kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": -1)"),
       "speed is -1; it must be from 1e-09 to 10000 rad/s"},
      {motion_with(R"("kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 1, "angle": 0)"),
       "angle is 0; it must be"},
      // Colliders.
      {scene_with(R"("colliders": {})"), "colliders is an object, not a list"},
      {scene_with(R"("colliders": [{}])"),
       R"(colliders[0].kind is missing; it must be one of "mesh", "sphere", "plane")"},
      {scene_with(R"("colliders": [{"kind": "capsule"}])"), R"(colliders[0].kind is "capsule", not one of)"},
      {scene_with(R"("colliders": [{"kind": "mesh"}])"), "colliders[0].mesh is missing; it must be a text"},
      {scene_with(R"("colliders": [{"kind": "mesh", "mesh": "dragon", "friction": 0.3}])"),
       "colliders[0].friction is not known"},
      {scene_with(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0]}])"),
       "colliders[0].radius is missing"},
      {scene_with(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": -1}])"),
       "colliders[0].radius is -1; it must be from 1e-06"},
      {scene_with(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "raduis": 1}])"),
       R"(did you mean "radius"?)"},
      {scene_with(R"("colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 0]}])"),
       "colliders[0].normal is zero"},
      {scene_with(R"("colliders": [{"kind": "plane", "normal": [0, 1, 0]}])"),
       "colliders[0].point is missing"},
  };
}

}  // namespace weft::scene

TEST_CASE("every hostile scene is refused as bad input with file, path, value and limit") {
  for (const Hostile& hostile : hostile_scenes()) {
    CAPTURE(hostile.text.substr(0, 300));
    const auto scene = parse_scene(hostile.text, "a.json");
    REQUIRE_FALSE(scene);
    CHECK(scene.error().kind == ErrorKind::Input);
    CHECK(scene.error().message.rfind("a.json: ", 0) == 0);
    CAPTURE(scene.error().message);
    CHECK(scene.error().message.find(hostile.message) != std::string::npos);
    CHECK((scene.error().message.back() == '.' || scene.error().message.back() == '?'));
    CHECK(scene.error().message.find("?.") == std::string::npos);
  }
  CHECK(hostile_scenes().size() >= 40);
}

TEST_CASE("the texts that hostile scenes are made of are good by themselves") {
  CHECK(parse_scene(minimal_scene(), "a.json"));
  CHECK(parse_scene(scene_with(R"("drag": 1)"), "a.json"));
  CHECK(parse_scene(cloth_with(R"("damping": 1)"), "a.json"));
  CHECK(parse_scene(motion_with(R"("kind": "path", "points": [[0, [0, 0, 0]]])"), "a.json"));
}
