#include "api/scenes.hpp"
#include "base/file.hpp"
#include "mesh/ply.hpp"
#include "temporary_folder.hpp"

using namespace weft;

TEST_CASE("a scene that is none, and a change that would make it none, are refused with the place") {
  const auto missing = Scene::from_text(R"({ "format": "weft-scene/1" })", "a.json");
  REQUIRE(!missing);
  CHECK(missing.error().kind == ErrorKind::Input);
  CHECK(missing.error().message.find("a.json") == 0);

  Scene scene = scene_of(kSheet);
  const auto refused = scene.set("cloths.0.density", "-1");
  REQUIRE(!refused);
  CHECK(refused.error().message.find("cloths[0].density is -1") != std::string::npos);
  const auto next = scene.set("cloths.0.damping", "0.1");  // the refused change has left nothing behind
  CHECK_MESSAGE(static_cast<bool>(next), next.error().message);
}

TEST_CASE("a copy of a scene goes its own way") {
  Scene scene = scene_of(kSheet);
  Scene copy = scene;
  const auto set = copy.set("cloths.0.grid", "[4, 5]");
  REQUIRE_OK(set);
  CHECK(world_of(scene).describe().nodes == 400);
  CHECK(world_of(copy).describe().nodes == 20);
}

TEST_CASE("a mesh that was added gives the bits of the same mesh from a file") {
  constexpr std::uint32_t kSide = 9;
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i)
      positions.push_back({0.1f * static_cast<float>(i), 0, 0.1f * static_cast<float>(j)});
  for (std::uint32_t j = 0; j + 1 < kSide; ++j)
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t a = j * kSide + i, b = a + 1, c = a + kSide, d = c + 1;
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  const char* const text = R"({ "format": "weft-scene/1",
    "cloths": [{ "mesh": "sail", "density": 0.2, "pins": [{ "nodes": [0, 8] }] }] })";
  Scene added = scene_of(text);
  const auto one = added.add_mesh("sail", positions, triangles);
  REQUIRE_OK(one);

  const TemporaryFolder folder;
  const auto written = write_file(folder.path("sail.ply"), mesh::write_ply({positions, triangles}));
  REQUIRE_OK(written);
  Scene read = scene_of(text);
  read.set_models_folder(folder.path(""));

  World first = world_of(added), second = world_of(read);
  CHECK(hash_after(first, 3) == hash_after(second, 3));
}

TEST_CASE(
    "a mesh with an index beyond its vertices is refused, and a mesh that is nowhere is missed by name") {
  Scene scene = scene_of(kSheet);
  const std::vector<Vec3f> positions(3);
  const std::vector<Triangle> triangles{{0, 1, 3}};
  const auto added = scene.add_mesh("bad", positions, triangles);
  REQUIRE(!added);
  CHECK(added.error().kind == ErrorKind::Input);
  CHECK(added.error().message.find("While adding mesh bad") == 0);

  const auto world = World::create(
      scene_of(R"({ "format": "weft-scene/1", "cloths": [{ "mesh": "nowhere", "density": 0.2 }] })"));
  REQUIRE(!world);
  CHECK(world.error().kind == ErrorKind::Input);
  CHECK(world.error().message.find("nowhere") != std::string::npos);
}
