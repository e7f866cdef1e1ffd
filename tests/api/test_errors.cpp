// Each error that the docstrings of Scene and World name and that no other file of these tests meets.
#include <cmath>

#include "api/scenes.hpp"
#include "temporary_folder.hpp"

using namespace weft;

TEST_CASE("a scene that cannot be read is refused by the path") {
  const auto missing = Scene::from_file("/nowhere/sheet.json");
  REQUIRE(!missing);
  CHECK(missing.error().kind == ErrorKind::Input);
  CHECK(missing.error().message.find("/nowhere/sheet.json") != std::string::npos);
}

TEST_CASE("a mesh without triangles and one with a coordinate that is not finite are refused") {
  Scene scene = scene_of(kSheet);
  std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(scene.add_mesh("empty", positions, {}).error().kind == ErrorKind::Input);
  positions[1].y = std::nanf("");
  const std::vector<Triangle> triangles{{0, 1, 2}};
  CHECK(scene.add_mesh("nan", positions, triangles).error().kind == ErrorKind::Input);
}

TEST_CASE("a drag that makes the running step unstable is refused, and the world stays as it was") {
  Scene scene = scene_of(kSheet);  // soft, so that its step is long beside the 0.2 ms that this drag allows
  REQUIRE_OK(scene.set("cloths.0.stiffness", R"({ "structural": 50, "shear": 20, "bend": 5 })"));
  REQUIRE_OK(scene.set("cloths.0.damping", "0.001"));
  World world = world_of(scene), plain = world_of(scene);
  REQUIRE_OK(world.advance());
  const auto refused = world.change("drag", "10000");
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message.find("With a drag of 10000 1/s the largest stable step is") == 0);
  CHECK(world.change("gravity", "down").error().kind == ErrorKind::Input);
  CHECK(hash_after(world, 2) == hash_after(plain, 3));
}

TEST_CASE("what cannot be grabbed is refused by the node, and more than 1024 nodes by the limit") {
  constexpr std::uint32_t kMost = 1024, free_row = 40;
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("cloths.0.grid", "[40, 40]"));
  World world = world_of(scene);
  CHECK(world.grab(1600, {}).error().message ==
        "Node 1600 cannot be grabbed: there are 1600 nodes, counted from 0.");
  CHECK(world.grab(0, {}).error().message == "Node 0 cannot be grabbed: it is pinned.");
  CHECK(world.grab(free_row, {std::nan(""), 0, 0}).error().kind == ErrorKind::Input);
  for (std::uint32_t k = 0; k < kMost; ++k) REQUIRE_OK(world.grab(free_row + k, {}));
  CHECK(world.grab(free_row, {}).error().message == "Node 40 cannot be grabbed: it is grabbed already.");
  CHECK(world.grab(free_row + kMost, {}).error().kind == ErrorKind::Limit);
  CHECK(world.drag(free_row, {0, std::nan(""), 0}).error().kind == ErrorKind::Input);
  CHECK(world.release(free_row + kMost).error().kind == ErrorKind::Input);
  REQUIRE_OK(world.reset());  // lets go
  REQUIRE_OK(world.grab(free_row + kMost, {}));
}

TEST_CASE("the shape comes as obj, ply and glb, and another format is refused by its name") {
  World world = world_of(scene_of(kSheet));
  for (const char* format : {"obj", "ply", "glb"}) {
    auto file = world.mesh_file(format);
    REQUIRE_OK(file);
    CHECK(file->size() > 400 * 3);  // of each node three numbers
  }
  const auto other = world.mesh_file("stl");
  REQUIRE(!other);
  CHECK(other.error().kind == ErrorKind::Input);
  CHECK(other.error().message == "The format stl is not known; there are obj, ply and glb.");
}

TEST_CASE(
    "a picture of what the scene lacks, and one larger than the GPU draws, are refused; the next is drawn") {
  World world = world_of(scene_of(kSheet));  // without contact
  PictureOptions options;
  options.width = options.height = 32;
  options.view = View::Contacts;
  const auto lacks = world.draw(options);
  REQUIRE(!lacks);
  CHECK(lacks.error().kind == ErrorKind::Input);
  options.view = View::Textured;
  options.width = 1'000'000;
  const auto large = world.draw(options);
  REQUIRE(!large);
  CHECK(large.error().kind == ErrorKind::Limit);
  CHECK(large.error().message.find("1000000 pixels") != std::string::npos);
  options.width = 32;
  auto drawn = world.draw(options);
  REQUIRE_OK(drawn);

  const TemporaryFolder folder;
  REQUIRE_OK(write_png(folder.path("end.png"), *drawn));
  const auto nowhere = write_png(folder.path("none/end.png"), *drawn);
  REQUIRE(!nowhere);
  CHECK(nowhere.error().kind == ErrorKind::Failure);
}
