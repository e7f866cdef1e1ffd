#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "base/file.hpp"
#include "scene/format.hpp"
#include "scene/load.hpp"
#include "scene/motion.hpp"
#include "scene/select.hpp"
#include "source_path.hpp"
#include "temporary_folder.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

const std::string kScenes = source_path("scenes/");

Scene loaded(const std::string& name) {
  auto scene = load_scene(kScenes + name);
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

}  // namespace

TEST_CASE("every shipped scene loads, says what it shows, and holds the nodes that it names") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.path().extension() != ".json") continue;
    const Scene scene = loaded(entry.path().filename().string());
    CAPTURE(scene.file);
    CHECK(!scene.title.empty());
    CHECK(!scene.description.empty());
    for (const Cloth& cloth : scene.cloths) {
      if (!cloth.grid) continue;
      const auto positions = grid_positions(*cloth.grid, cloth.transform);
      CHECK(kinematic_nodes(cloth, {positions, cloth.grid->nx, cloth.grid->ny}));
    }
    ++count;
  }
  CHECK(count >= 16);
}

TEST_CASE("the scenes of contact use proximity, place their own camera and take any grid") {
  for (const char* name : {"drape-sphere", "drape-armadillo", "drape-dragon", "twist", "stack", "funnel",
                           "flag", "shot", "incline"}) {
    CAPTURE(name);
    for (const char* grid : {"[2,2]", "[24,24]", "[257,129]"}) {
      const Override change[] = {{"cloths.0.grid", grid}};
      const auto scene = load_scene(kScenes + name + ".json", change);
      if (!scene) FAIL(scene.error().message);
      CHECK(scene->contact.method == ContactMethod::Proximity);
      CHECK(scene->contact.self);
      CHECK(scene->camera);
      CHECK_FALSE(scene->time.substeps);
      const Cloth& cloth = scene->cloths[0];
      CHECK(kinematic_nodes(cloth,
                            {grid_positions(*cloth.grid, cloth.transform), cloth.grid->nx, cloth.grid->ny}));
    }
  }
}

TEST_CASE("the stack is sixteen sheets, and fifty of 4900 nodes are its full size") {
  CHECK(loaded("stack.json").cloths.size() == 16);
  const Override full[] = {{"cloths.0.copies.count", "50"}, {"cloths.0.grid", "[70,70]"}};
  const auto scene = load_scene(kScenes + "stack.json", full);
  REQUIRE(scene);
  CHECK(scene->cloths.size() == 50);
  CHECK(scene->cloths[49].transform.translate.y == doctest::Approx(0.02 + 49 * 0.008));
}

TEST_CASE("the sheet on the incline lies at its thickness on a slope that its friction holds") {
  const Scene scene = loaded("incline.json");
  CHECK(scene.cloths[0].transform.translate.y == scene.contact.thickness);
  CHECK(length(scene.gravity) == doctest::Approx(9.81).epsilon(1e-6).scale(0));
  CHECK(scene.gravity.x / -scene.gravity.y == doctest::Approx(std::tan(20 * std::acos(-1.0) / 180)));
  CHECK(friction_of(scene.colliders[0]) == 0.5);
}

TEST_CASE("the hanging scene is the cloth of the figures, the paper's has the paper's habits") {
  const Scene hanging = loaded("hanging.json");
  CHECK(hanging.cloths[0].density == 0.2);
  CHECK(hanging.contact.method == ContactMethod::None);
  CHECK_FALSE(hanging.time.substeps);
  const Scene paper = loaded("hanging-paper.json");
  CHECK(paper.cloths[0].node_mass == 20.0);
  CHECK(paper.cloths[0].stiffness.bend == 219000);
  CHECK(paper.time.substeps == 1U);
  CHECK(paper.time.frame == 0.005);
  CHECK(paper.solver.forces == Forces::SpringCentric);
}

TEST_CASE("a mesh is a model's name or a path beside the scene") {
  const TemporaryFolder folder;
  REQUIRE(make_folder(folder.path("models")));
  REQUIRE(write_file(folder.path("models/drag-on_2.ply"), std::string("ply")));
  const std::string models = folder.path("models");
  Scene scene;
  scene.file = "scenes/a.json";
  CHECK(*mesh_path(scene, "drag-on_2", models) == models + "/drag-on_2.ply");
  CHECK(*mesh_path(scene, "shirt.obj", models) == "scenes/shirt.obj");
  CHECK(*mesh_path(scene, "../meshes/shirt.ply", models) == "scenes/../meshes/shirt.ply");
  CHECK(*mesh_path(scene, "/tmp/shirt.ply", models) == "/tmp/shirt.ply");
  scene.file = "a.json";
  CHECK(*mesh_path(scene, "shirt.obj", models) == "shirt.obj");
  CHECK(mesh_path(scene, "dragon", models).error().message ==
        "a.json: model \"dragon\" is not at " + models +
            "/dragon.ply; ./dev build makes the models, WEFT_MODELS names their folder.");
  CHECK(mesh_path(scene, std::string("a\0.ply", 6), models).error().kind == ErrorKind::Input);
  CHECK(mesh_path(scene, "", models).error().kind == ErrorKind::Input);
}

namespace {

void collect(const Type& type, std::vector<std::string>& words) {
  for (const char* choice : type.choices) words.push_back("\"" + std::string(choice) + "\"");
  for (const Type* inner : type.types) collect(*inner, words);
  const auto keys = [&](std::span<const Key> all) {
    for (const Key& key : all) {
      words.push_back(key.name);
      collect(*key.type, words);
    }
  };
  keys(type.keys);
  for (const Variant& variant : type.variants) keys(variant.keys);
}

}  // namespace

TEST_CASE("docs/scene.md names every key and every choice") {
  const auto bytes = read_file(source_path("docs/scene.md"), 1 << 20);
  REQUIRE(bytes);
  const std::string docs(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  std::vector<std::string> words;
  collect(scene_type(), words);
  CHECK(words.size() > 100);
  for (const std::string& word : words) {
    CAPTURE(word);
    CHECK(docs.find("`" + word + "`") != std::string::npos);
  }
}

TEST_CASE("the example of docs/scene.md is a scene, whose flag turns about its pole") {
  const auto bytes = read_file(source_path("docs/scene.md"), 1 << 20);
  REQUIRE(bytes);
  const std::string docs(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  const std::size_t start = docs.find("```json\n") + 8;
  const auto scene = parse_scene(docs.substr(start, docs.find("```", start) - start), "docs/scene.md");
  if (!scene) FAIL(scene.error().message);
  const Cloth& flag = scene->cloths[0];
  const auto positions = grid_positions(*flag.grid, flag.transform);
  const auto kinematic = kinematic_nodes(flag, {positions, flag.grid->nx, flag.grid->ny});
  REQUIRE(kinematic);
  for (const std::uint32_t node : kinematic->motions[0])  // the pole is the axis, so its nodes stay
    CHECK(length(motion_at(flag.motions[0], 10)(positions[node]) - positions[node]) < 1e-12);
}
