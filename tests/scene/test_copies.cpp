#include <doctest/doctest.h>

#include "scene/difference.hpp"
#include "scene/load.hpp"
#include "scene/motion.hpp"
#include "scene/select.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Scene parsed(const std::string& text, std::span<const Override> overrides = {}) {
  auto scene = parse_scene(text, "a.json", overrides);
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

// 4 by 3 nodes over 3 m by 2 m, turned over its own z axis by a half, stood three times 5 m apart.
const std::string kThree = cloth_with(
    R"("transform": {"rotate": [0, 0, 1, 0], "translate": [1, 0, 0]}, "copies": {"count": 3, "offset": [0, 1, 5]},
       "pins": [{"box": {"min": [-1, -2, -1], "max": [0, 2, 1]}}, {"nodes": [3]}],
       "motions": [{"nodes": {"near": {"point": [2.5, -1, 0], "radius": 0.1}}, "kind": "rotation",
                    "axis": [1, 0, 0], "center": [0, -2, 0], "speed": 1}])");

std::vector<Vec3d> positions_of(const Cloth& cloth) { return grid_positions(*cloth.grid, cloth.transform); }

}  // namespace

TEST_CASE("copy k of a cloth is the cloth k offsets further on, with the same kinematic nodes") {
  const Scene scene = parsed(kThree);
  REQUIRE(scene.cloths.size() == 3);
  const Cloth& first = scene.cloths[0];
  CHECK(first.transform.translate == Vec3d{1, 0, 0});
  const std::vector<Vec3d> places = positions_of(first);
  const auto kinematic = kinematic_nodes(first, {places, 4, 3});
  REQUIRE(kinematic);
  REQUIRE(kinematic->motions[0].size() == 1);
  CHECK(kinematic->pins.size() >= 3);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Cloth& copy = scene.cloths[k];
    const Vec3d shift = Vec3d{0, 1, 5} * k;
    CHECK(copy.where == "a.json: cloths[0]");
    CHECK(copy.copy == k);
    const std::vector<Vec3d> there = positions_of(copy);
    for (std::size_t node = 0; node < places.size(); ++node)
      CHECK(length(there[node] - places[node] - shift) < 1e-14);
    const auto same = kinematic_nodes(copy, {there, 4, 3});
    REQUIRE(same);
    CHECK(same->pins == kinematic->pins);
    CHECK(same->motions == kinematic->motions);
    const std::uint32_t node = kinematic->motions[0][0];
    const Vec3d moved = motion_at(copy.motions[0], 0.7)(there[node]);
    CHECK(length(moved - motion_at(first.motions[0], 0.7)(places[node]) - shift) < 1e-13);
    CHECK(length(moved - there[node]) > 0.1);
  }
}

TEST_CASE("lines, paths, lists and parts of a grid mean the same in every copy") {
  const Scene scene = parsed(cloth_with(R"("copies": {"count": 2, "offset": [7, 0, 0]}, "pins": ["left"],
    "motions": [{"nodes": {"nodes": [3]}, "kind": "line", "direction": [1, 0, 0], "speed": 1},
                {"nodes": "bottom_right", "kind": "path", "points": [[1, [0, 0, 1]]]}])"));
  REQUIRE(scene.cloths.size() == 2);
  CHECK(scene.cloths[1].pins == scene.cloths[0].pins);
  CHECK(scene.cloths[1].motions == scene.cloths[0].motions);
}

TEST_CASE("messages name the entry of a cloth, however many copies stand before it") {
  const std::string two = R"({"format": "weft-scene/1", "cloths": [
    {"grid": [4, 3], "size": [3, 2], "density": 0.2, "copies": {"count": 4, "offset": [0, 0, 1]}},
    {"grid": [4, 3], "size": [3, 2], "density": 0.2, "pins": ["left"], "copies": {"count": 2, "offset": [0, 0, 1]}}]})";
  const Scene scene = parsed(two);
  REQUIRE(scene.cloths.size() == 6);
  CHECK(scene.cloths[4].where == "a.json: cloths[1]");
  CHECK(scene.cloths[5].pins[0].where == "a.json: cloths[1].pins[0]");
  const auto difference = [&](const char* key, const char* value) {
    const Override change[] = {{key, value}};
    return fixed_difference(scene, parsed(two, change)).value_or("none");
  };
  CHECK(difference("cloths[1].damping", "3") == "cloths[1].damping");
  CHECK(difference("cloths[1].copies.offset", "[0, 0, 2]") == "cloths[1].copies");
  CHECK(difference("cloths[1].transform.translate", "[0, 0, 2]") == "cloths[1].transform");
  CHECK(difference("cloths[0].copies.count", "3") == "cloths");
}

TEST_CASE("the count and the offset of copies can be set, up to the limits") {
  const Override full[] = {{"cloths.0.copies.count", "1000"}, {"cloths.0.copies.offset", "[0, 0.01, 0]"}};
  const Scene scene = parsed(kThree, full);
  REQUIRE(scene.cloths.size() == 1000);
  CHECK(scene.cloths[999].transform.translate.y == doctest::Approx(9.99));
  CHECK(parsed(cloth_with(R"("copies": {"count": 1, "offset": [0, 0, 0]})")).cloths.size() == 1);
  CHECK(
      parsed(
          cloth_of(
              R"("grid": [256, 256], "size": [1, 1], "density": 1, "copies": {"count": 1000, "offset": [0, 0, 1]})"))
          .cloths.size() == 1000);
}
