#include <cmath>

#include "api/scenes.hpp"

using namespace weft;

namespace {

/// Two upright sheets of 9 x 9 nodes, the second 0.5 m behind the first and twice.
constexpr const char* kSheets = R"({ "format": "weft-scene/1", "solver": {"kind": "mass_spring"},
    "contact": { "method": "none" }, "cloths": [
  { "grid": [9, 9], "size": [1, 1], "plane": "xy", "density": 0.2, "pins": ["top"] },
  { "grid": [9, 9], "size": [1, 1], "plane": "xy", "density": 0.2, "pins": ["top"],
    "transform": { "translate": [0, 0, -0.5] }, "copies": { "count": 2, "offset": [3, 0, 0] } }] })";

std::vector<Vec3f> positions_of(World& world) {
  std::vector<Vec3f> positions(world.position().count());
  REQUIRE_OK(world.position().read(positions));
  return positions;
}

}  // namespace

TEST_CASE("a ray through a node picks it, its cloth and the place") {
  World world = world_of(scene_of(kSheets));
  REQUIRE_OK(world.advance(3));
  const std::vector<Vec3f> positions = positions_of(world);
  REQUIRE(positions.size() == 3 * 81);
  for (std::uint32_t node = 0; node < positions.size(); ++node) {
    const Vec3d at = positions[node].to<double>();
    // The first sheet from before it, the others from behind, a little within the rim; the direction has any length.
    const Vec3d middle =
        0.5 * (positions[node / 81 * 81].to<double>() + positions[node / 81 * 81 + 80].to<double>());
    const Vec3d aim = at + 1e-6 * (middle - at);
    const Vec3d eye = aim + Vec3d{0.01, 0.02, node < 81 ? 2.0 : -2.0};
    auto picked = world.pick(Ray{eye, 0.3 * (aim - eye)});
    REQUIRE_OK(picked);
    REQUIRE(picked->has_value());
    CHECK((*picked)->cloth == node / 81);
    CHECK((*picked)->node == node);
    CHECK(length((*picked)->point - at) < 2e-6);  // the sheet is 1 m wide, and hardly bent yet
    CHECK((*picked)->distance == doctest::Approx(length(aim - eye)).epsilon(1e-6).scale(0));
    bool corner = false;
    for (const std::uint32_t of : world.triangles()[(*picked)->triangle]) corner = corner || of == node;
    CHECK(corner);
  }
}

TEST_CASE("a place of a picture picks the node that the camera sees there, and nothing beside the cloth") {
  World world = world_of(scene_of(kSheets));
  const std::vector<Vec3f> positions = positions_of(world);
  const Vec3d middle = 0.5 * (positions[0].to<double>() + positions[80].to<double>());
  PictureOptions options;
  options.width = 320;
  options.height = 200;
  options.camera = Camera{middle + Vec3d{0, 0, 3}, middle, 30};
  const double scale = 100 / std::tan(15 * 3.14159265358979 / 180);  // pixels of 1 m at a distance of 1 m
  for (std::uint32_t node = 0; node < 81; ++node) {
    const Vec3d off = positions[node].to<double>() - middle;
    // A tenth of a pixel towards the middle, so that a node of the rim is met.
    const double x = 160 + scale * off.x / (3 - off.z), y = 100 - scale * off.y / (3 - off.z);
    auto picked = world.pick(x + (off.x > 0 ? -0.1 : 0.1), y + (off.y > 0 ? 0.1 : -0.1), options);
    REQUIRE_OK(picked);
    REQUIRE(picked->has_value());
    CHECK((*picked)->node == node);
    CHECK((*picked)->cloth == 0);
  }
  auto beside = world.pick(1, 1, options);
  REQUIRE_OK(beside);
  CHECK(!beside->has_value());
}

TEST_CASE("without a camera a place is one of the picture that draw makes") {
  Scene scene = scene_of(kSheets);
  REQUIRE_OK(scene.set("render.size", "[200, 100]"));
  REQUIRE_OK(scene.set("camera", R"({ "eye": [0.1, 0.2, 4], "target": [0.1, 0.2, 0] })"));
  World world = world_of(scene);
  PictureOptions same;
  same.camera = Camera{{0.1, 0.2, 4}, {0.1, 0.2, 0}};
  auto by_scene = world.pick(103, 47), by_options = world.pick(103, 47, same);
  REQUIRE_OK(by_scene);
  REQUIRE_OK(by_options);
  REQUIRE(by_scene->has_value());
  CHECK((*by_scene)->point == (*by_options)->point);
  CHECK(world.pick(201, 50).error().kind == ErrorKind::Input);  // past the scene's 200 pixels
}

TEST_CASE("a ray without a direction and a place outside the picture are refused") {
  World world = world_of(scene_of(kSheets));
  const auto still = world.pick(Ray{{0, 0, 1}, {}});
  REQUIRE(!still);
  CHECK(still.error().kind == ErrorKind::Input);
  CHECK(still.error().message == "A ray from (0, 0, 1) along (0, 0, 0) has no place or no direction.");
  CHECK(world.pick(Ray{{std::nan(""), 0, 1}, {0, 0, 1}}).error().kind == ErrorKind::Input);
  PictureOptions options;
  options.width = 320;
  options.height = 200;
  const auto outside = world.pick(320.5, 10, options);
  REQUIRE(!outside);
  CHECK(outside.error().message == "The place (320.5, 10) is outside the picture of 320 x 200 pixels.");
  CHECK(world.pick(std::nan(""), 10, options).error().kind == ErrorKind::Input);
  options.height = 0;
  CHECK(world.pick(1, 0, options).error().message == "A picture of 320 x 0 pixels is empty.");
}
