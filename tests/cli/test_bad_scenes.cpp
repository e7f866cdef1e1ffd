#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>

#include "weft.hpp"

using namespace weft;

namespace {

struct BadScene {
  std::string text;
  std::string words;  // of the message
};

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

/// A scene of one cloth whose fabric has these keys.
std::string scene_of_fabric(const std::string& fabric, const std::string& more = "") {
  return scene_of_cloth(R"("grid": [4, 4], "size": [1, 1], "density": 0.2, "fabric": {)" + fabric + "}" +
                        more);
}

std::vector<BadScene> bad_scenes() {
  const std::string good = tiny_scene();
  const std::string line = R"("kind": "line", "direction": [1, 0, 0], "speed": 1)";
  return {
      // Not JSON, or not of this world.
      {"", "syntax error"},
      {"hello", "line 1, column 1"},
      {good.substr(0, good.size() / 2), "syntax error"},
      {good + good, "syntax error"},
      {std::string(1000, '\0'), "syntax error"},
      {"\xff\xfe" + good, "line 1, column 1"},
      {"[]", "the scene is a list of 0, not an object"},
      {"{}", "format is missing"},
      {R"({"format": "weft-scene/9", "cloths": []})", "format is \"weft-scene/9\", not \"weft-scene/1\""},
      {repeated("[", 1'000'000), "nesting is deeper than the limit of 64 levels"},
      {R"({"format": "weft-scene/1", "cloths": )" + repeated("[", 100) + repeated("]", 100) + "}",
       "64 levels"},
      {repeated("{\"a\":", 200'000), "64 levels"},
      {"[" + repeated("0,", 1'100'000) + "0]", "1048576"},
      {std::string(17U << 20U, ' '), "16777216"},
      {R"({"format": ")" + std::string(1'000'000, 'x') + "\"}", "format is \""},
      {R"({"format": "weft-scene/1", "format": "weft-scene/1"})", "format is given twice"},
      {tiny_scene("", R"("color": [1, 0, 0], "color": [1, 0, 0], )"), "cloths[0].color is given twice"},
      // Keys and values.
      {tiny_scene(R"("gravty": [0, 0, 0], )"), "gravty is not known; did you mean \"gravity\"?"},
      {tiny_scene("", R"("stifness": {}, )"), "cloths[0].stifness is not known; did you mean \"stiffness\"?"},
      {tiny_scene(R"("a\nb\u001b[31m": 1, )"), "is not known"},
      {tiny_scene(R"("drag": "much", )"), "drag is the text \"much\", not a number"},
      {tiny_scene(R"("drag": 1e999, )"), "number overflow parsing"},
      {tiny_scene(R"("drag": NaN, )"), "syntax error"},
      {tiny_scene(R"("drag": -1, )"), "drag is -1; it must be from 0 to 10000 1/s"},
      {tiny_scene(R"("gravity": [0, null, 0], )"), "gravity[1] is null, not a number"},
      {tiny_scene(R"("solver": {"kind": "mas_spring"}, )"), "did you mean \"mass_spring\"?"},
      {tiny_scene(R"("solver": {"kind": "newton"}, )"), "solver.kind is \"newton\""},
      {R"({"format": "weft-scene/1", "solver": {"kind": "xpbd"}, "cloths": [{"grid": [4, 4], "size": [1, 1],
           "density": 0.2, "stiffness": {"bending": 1e-4}}]})",
       "cloths[0] has bending of grids (stiffness.bending), which solver.kind \"xpbd\" does not take; "
       "\"multigrid\", \"mass_spring\" or \"fem\" does."},
      {R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "cloths": [{"grid": [4, 4], "size": [1, 1],
           "density": 0.2, "strain_limit": 0.1}]})",
       "cloths[0].strain_limit is 0.1, and solver.kind \"mass_spring\" keeps none; \"multigrid\" or \"fem\" "
       "does."},
      {R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring", "forces": "spring_centric"}, "cloths": [{
           "grid": [4, 4], "size": [1, 1], "density": 0.2, "fabric": {"warp": 9, "shear": 3, "bending_warp": 0}}]})",
       "cloths[0].fabric has no springs; solver.forces \"spring_centric\" has springs only"},
      {scene_of_fabric(R"("shear": 3, "bending_warp": 0)"),
       "cloths[0].fabric.warp is missing; it must be a number"},
      {scene_of_fabric(R"("warp": 9, "weft": 36, "poisson": 0.5, "shear": 3, "bending_warp": 0)"),
       "fabric.poisson is 0.5; its square must be below 0.9999 warp / weft, 0.249975"},
      {scene_of_fabric(R"("warp": 9, "weft": 8, "shear": 4.5, "bending_warp": 0, "energy": "neo_hookean")"),
       "fabric.weft is 8 N/m; energy \"neo_hookean\" has no axes and needs that of warp, 9"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0, "energy": "neo_hookean")"),
       "fabric.shear is 3 N/m; energy \"neo_hookean\" has no axes and needs warp / (2 + 2 poisson), 4.5"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0)", R"(, "stiffness": {"bend": 1})"),
       "cloths[0].stiffness is of springs; a cloth with \"fabric\" has none"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0)", R"(, "damping": 1)"),
       "cloths[0].damping is of springs; a cloth with \"fabric\" has fabric.damping instead"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0, "warp_direction": [0, 1, 0])"),
       "cloths[0].fabric.warp_direction is of meshes; the warp of a grid goes along i"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0, "rest_angles": "flat")"),
       "cloths[0].fabric.rest_angles is of meshes; a grid is flat at rest"},
      {scene_of_fabric(R"("warp": 9, "shear": 3, "bending_warp": 0)", R"(, "strain_limit": 0.0009)"),
       "strain_limit is 0.0009; it must be from 0.001 to 10"},
      {scene_of_cloth(R"("grid": [4, 4], "size": [1, 1], "density": 0.2, "strain_limit": 0)"),
       "strain_limit is 0; it must be from 0.001 to 10"},
      {scene_of_cloth(R"("grid": [4, 4], "size": [1, 1], "density": 0.2, "pressure": {"gauge": 5})"),
       "cloths[0].pressure needs \"mesh\" beside it"},
      {scene_of_cloth(R"("mesh": "sphere", "density": 0.2, "pressure": {"ambient": 5})"),
       "cloths[0].pressure.gauge is missing; it must be a number"},
      {scene_of_cloth(R"("mesh": "sphere", "density": 0.2, "pressure": {"gauge": -20, "ambient": 20})"),
       "cloths[0].pressure.gauge is -20 Pa; with the ambient one, 20 Pa, the pressure of a gas must be above "
       "0"},
      {scene_of_cloth(R"("mesh": "sphere", "density": 0.2, "pressure": {"gauge": 2, "law": "adiabatic"})"),
       "cloths[0].pressure.law is \"adiabatic\""},
      {scene_of_cloth(R"("mesh": "skirt", "density": 0.2, "pressure": {"gauge": 2})"),
       "cloths[0].pressure needs a closed mesh; "},
      {tiny_scene(R"("contact": {"method": "bvhh"}, )"), "did you mean \"bvh\"?"},
      {tiny_scene(R"("camera": {"eye": [0, 0, 1], "target": [0, 0, 1]}, )"), "camera.target"},
      {scene_of_cloth(R"("density": 0.2)"), "has neither \"grid\" nor \"mesh\""},
      {scene_of_cloth(R"("grid": [1, 3], "size": [1, 1], "density": 0.2)"),
       "grid[0] is 1; it must be from 2 to 16384"},
      {scene_of_cloth(R"("grid": [1e30, 3], "size": [1, 1], "density": 0.2)"), "grid[0] is 1e+30"},
      {scene_of_cloth(R"("grid": [16384, 16384], "size": [1, 1], "density": 0.2)"), "limit of 67108864"},
      {scene_of_cloth(R"("grid": [4, 3], "size": [1, 1], "density": 0)"), "density is 0; it must be from"},
      // Pins and motions.
      {tiny_scene("",
                  R"("motions": [{"nodes": [{"near": {"point": [9, 9, 9], "radius": 1}}], )" + line + "}], "),
       "selects none of the cloth's 30 nodes"},
      {tiny_scene("", R"("motions": [{"nodes": "top", )" + line + "}], "),
       "a node is pinned or moved, not both"},
      {tiny_scene("",
                  R"("motions": [{"nodes": "top", )" + line + R"(}, {"nodes": "right", )" + line + "}], "),
       "node 0"},
      {tiny_scene("", R"("motions": [{"nodes": [{"nodes": [30]}], )" + line + "}], "),
       "names node 30; there are 30 nodes"},
      {tiny_scene("", R"("motions": [{"nodes": "topp", )" + line + "}], "), "did you mean \"top\"?"},
      // Colliders.
      {tiny_scene(R"("colliders": [{"kind": "spere", "center": [0, 0, 0], "radius": 1}], )"),
       "did you mean \"sphere\"?"},
      {tiny_scene(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": -1}], )"),
       "radius is -1"},
      {tiny_scene(
           R"("colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "rigid": {"mass": 1}}], )"),
       "colliders[0].rigid is of a plane; spheres, boxes, capsules and convex hulls can be rigid bodies."},
      {tiny_scene(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "rigid": {}}], )"),
       "colliders[0].rigid has neither \"density\" nor \"mass\"; it must have one of them."},
      {tiny_scene(
           R"("contact": {"method": "bvh"}, "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1,
                     "rigid": {"mass": 1}}], )"),
       "colliders[0].rigid needs contact.method \"proximity\"; it is \"bvh\"."},
      {tiny_scene(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "rigid": {"mass": 1},
                     "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 1}}], )"),
       "colliders[0] has a motion and is rigid; it moves by one of them."},
      {tiny_scene(R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1, "rigid": {"mass": 1}},
                     {"kind": "mesh", "mesh": "sphere"}], )"),
       "colliders[1] is a mesh, which rigid bodies do not meet; they meet spheres, boxes, capsules, planes "
       "and "
       "convex hulls."},
      {tiny_scene(R"("colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 0]}], )"),
       "normal is zero"},
  };
}

}  // namespace

TEST_CASE("every bad scene is refused by check and by run in one sentence that names it") {
  const auto table = bad_scenes();
  CHECK(table.size() >= 40);
  for (const BadScene& bad : table) {
    CAPTURE(bad.text.substr(0, 200));
    const TemporaryFolder folder;
    put(folder, "a.json", bad.text);
    const CallOptions there = {{}, folder.path(""), false};
    const Ended checked = run_without_driver({"check", "a.json"}, there);
    // A value of two bytes takes about a hundred in memory, and there are at most 1,048,576.
    CHECK(check_refusal(checked, 3, bad.words, 8 * bad.text.size()) == "");
    CHECK(checked.err.find("a.json") != std::string::npos);
    const Ended ran = run_weft({"run", "a.json", "--out", "out"}, there);
    CHECK(ran.code == 3);
    CHECK(ran.err == checked.err);
    CHECK(names_in(folder.path("")) == std::vector<std::string>{"a.json"});
  }
}

TEST_CASE("scenes that are no files are refused") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("folder"));
  put(folder, "secret.json", tiny_scene());
  REQUIRE(::chmod(folder.path("secret.json").c_str(), 0) == 0);
  REQUIRE(::mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  const std::pair<std::string, std::string> rows[] = {
      {"missing.json", "missing.json cannot be read: No such file or directory"},
      {"", "There is no shipped scene \"\""},
      {"folder", "There is no shipped scene \"folder\""},  // by its name alone, whatever lies there
      {"./folder", "folder is not a regular file"},
      {"secret.json", "secret.json cannot be read: Permission denied"},
      {"secret.json/a", "cannot be read: Not a directory"},
      {"./pipe", "pipe is not a regular file"},
      {"/dev/zero", "/dev/zero is not a regular file"},
      {"a\nb.json", "a?b.json cannot be read"},
  };
  for (const auto& [path, words] : rows) {
    const Ended ended = run_without_driver({"check", path}, {{}, folder.path(""), false});
    CAPTURE(path);
    CHECK(check_refusal(ended, 3, words, 0) == "");
  }
  const Ended ended = run_without_driver({"check", std::string(100'000, 'x')});
  CHECK(ended.code == 3);
  CHECK(check_message(ended.err) == "");
  CHECK(ended.err.size() < 5000);
}

TEST_CASE("changes of a scene that do not fit are refused") {
  const TemporaryFolder folder;
  put(folder, "a.json", tiny_scene());
  const std::pair<std::string, std::string> rows[] = {
      {"cloths.1.grid=[4,4]", "cloths has no entry 1"},
      {"cloths.x=1", "\"x\" is not an index"},
      {"cloths.0.gird=[4,4]", "did you mean \"grid\"?"},
      {"cloths.0.grid=[4,4", "syntax error"},
      {"cloths.0.grid=[4]", "a list of 1, not a list of 2"},
      {"drag.a.b.c=1", "drag"},
      {"format=other", "format is \"other\""},
      {"=1", ""},
      {"a" + std::string(100'000, '.') + "=1", ""},
      {"title=" + repeated("[", 100'000), "64 levels"},
  };
  for (const auto& [change, words] : rows) {
    const Ended ended =
        run_without_driver({"check", "a.json", "--set", change}, {{}, folder.path(""), false});
    CAPTURE(change.substr(0, 100));
    CHECK(check_refusal(ended, change[0] == '=' ? 2 : 3, words, change.size()) == "");
  }
  const Ended solver =
      run_without_driver({"check", "a.json", "--solver", "explicit"}, {{}, folder.path(""), false});
  CHECK(check_refusal(solver, 3, "solver.kind is \"explicit\"", 0) == "");
}
