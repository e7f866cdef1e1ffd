#include <doctest/doctest.h>

#include "mesh/allocation_meter.hpp"
#include "scene/load.hpp"
#include "scene/select.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

using Nodes = std::vector<std::uint32_t>;

// The minimal scene's grid, 4 by 3 nodes over 3 m by 2 m:
//   0  1  2  3     y = 1, j = 0: top
//   4  5  6  7     y = 0
//   8  9 10 11     y = -1: bottom;   x = -1.5 (left) ... 1.5 (right)
struct Sheet {
  Scene scene;
  std::vector<Vec3d> positions;
  Selection selection;

  explicit Sheet(const std::string& members) : scene(*parse_scene(cloth_with(members), "a.json")) {
    const Cloth& cloth = scene.cloths[0];
    positions = grid_positions(*cloth.grid, cloth.transform);
    selection = {positions, cloth.grid->nx, cloth.grid->ny};
  }
};

Result<Nodes> pinned(const std::string& selector) {
  const Sheet sheet("\"pins\": [" + selector + "]");
  return select_nodes(sheet.scene.cloths[0].pins, sheet.selection);
}

std::string failure(const std::string& members) {
  const Sheet sheet(members);
  const auto kinematic = kinematic_nodes(sheet.scene.cloths[0], sheet.selection);
  REQUIRE_FALSE(kinematic);
  CHECK(kinematic.error().kind == ErrorKind::Input);
  return kinematic.error().message;
}

}  // namespace

TEST_CASE("a hanging grid has row 0 at the top, a flat one at the back, both centred") {
  const auto hanging = grid_positions({4, 3, 3, 2, Plane::Xy}, {});
  REQUIRE(hanging.size() == 12);
  CHECK(hanging[0] == Vec3d{-1.5, 1, 0});
  CHECK(hanging[3] == Vec3d{1.5, 1, 0});
  CHECK(hanging[11] == Vec3d{1.5, -1, 0});
  const auto flat = grid_positions({4, 3, 3, 2, Plane::Xz}, {1, {0, 0, 0, 1}, {0, 5, 0}});
  CHECK(flat[0] == Vec3d{-1.5, 5, -1});
  CHECK(flat[3] == Vec3d{1.5, 5, -1});
  CHECK(flat[11] == Vec3d{1.5, 5, 1});
}

TEST_CASE("parts of a grid are found by name") {
  CHECK(*pinned(R"("top_left")") == Nodes{0});
  CHECK(*pinned(R"("top_right")") == Nodes{3});
  CHECK(*pinned(R"("bottom_left")") == Nodes{8});
  CHECK(*pinned(R"("bottom_right")") == Nodes{11});
  CHECK(*pinned(R"("top")") == Nodes{0, 1, 2, 3});
  CHECK(*pinned(R"("bottom")") == Nodes{8, 9, 10, 11});
  CHECK(*pinned(R"("left")") == Nodes{0, 4, 8});
  CHECK(*pinned(R"("right")") == Nodes{3, 7, 11});
  CHECK(*pinned(R"("corners")") == Nodes{0, 3, 8, 11});
  CHECK(*pinned(R"("edges")") == Nodes{0, 1, 2, 3, 4, 7, 8, 9, 10, 11});
}

TEST_CASE("boxes, balls and lists select by place and index, faces included") {
  CHECK(*pinned(R"({"box": {"min": [-0.5, 0, -1], "max": [1.5, 1, 1]}})") == Nodes{1, 2, 3, 5, 6, 7});
  CHECK(*pinned(R"({"box": {"min": [-0.5, 0, 0], "max": [-0.5, 0, 0]}})") == Nodes{5});
  CHECK(*pinned(R"({"near": {"point": [0.5, 0, 0], "radius": 1}})") == Nodes{2, 5, 6, 7, 10});
  CHECK(*pinned(R"({"nodes": [7, 2, 7]})") == Nodes{2, 7});
}

TEST_CASE("several selectors are united, each node once") {
  CHECK(*pinned(R"("top", "left", {"nodes": [4, 6]})") == Nodes{0, 1, 2, 3, 4, 6, 8});
}

TEST_CASE("a hundred selectors of the same nodes take no more memory than one") {
  std::string pins = R"("edges")";
  const auto peak = [&] {
    const Scene scene = *parse_scene(
        cloth_of(R"("grid": [100, 100], "size": [1, 1], "density": 0.2, "pins": [)" + pins + "]"), "a.json");
    const Cloth& cloth = scene.cloths[0];
    const auto positions = grid_positions(*cloth.grid, cloth.transform);
    const AllocationMeter meter;
    const auto nodes = select_nodes(cloth.pins, {positions, cloth.grid->nx, cloth.grid->ny});
    REQUIRE(nodes);
    CHECK(nodes->size() == 396);
    return meter.peak();
  };
  const std::size_t one = peak();
  for (int k = 1; k < 100; ++k) pins += R"(, "edges")";
  CHECK(peak() <= one);
}

TEST_CASE("a box and a ball see the sheet where its transform puts it") {
  const Sheet sheet(R"("transform": {"scale": 2, "translate": [0, 0, 7]},
                       "pins": [{"box": {"min": [2.9, 1.9, 6.9], "max": [3.1, 2.1, 7.1]}}])");
  CHECK(*select_nodes(sheet.scene.cloths[0].pins, sheet.selection) == Nodes{3});
}

TEST_CASE("a selector that selects nothing, or past the end, is named with its path") {
  CHECK(failure(R"("pins": ["top", {"near": {"point": [9, 9, 9], "radius": 1}}])") ==
        "a.json: cloths[0].pins[1] selects none of the cloth's 12 nodes.");
  CHECK(failure(R"("pins": [{"nodes": [3, 12]}])") ==
        "a.json: cloths[0].pins[0] names node 12; there are 12 nodes, counted from 0.");
  const Selector part{"a.json: cloths[0].pins[0]", GridPart::Top};
  const std::vector<Vec3d> positions(5);
  CHECK(select_nodes(part, {positions}).error().message ==
        "a.json: cloths[0].pins[0] is a part that only a grid has.");
}

TEST_CASE("pins and motions hold their nodes, and share none") {
  const std::string right = R"({"nodes": "right", "kind": "line", "direction": [1, 0, 0], "speed": 1})";
  const Sheet sheet("\"pins\": [\"left\"], \"motions\": [" + right + "]");
  const auto kinematic = kinematic_nodes(sheet.scene.cloths[0], sheet.selection);
  REQUIRE(kinematic);
  CHECK(kinematic->pins == Nodes{0, 4, 8});
  REQUIRE(kinematic->motions.size() == 1);
  CHECK(kinematic->motions[0] == Nodes{3, 7, 11});
  CHECK(failure("\"pins\": [\"top\"], \"motions\": [" + right + "]") ==
        "a.json: cloths[0].motions[0] holds node 3, which the cloth's pins hold too; a node is pinned or "
        "moved, not both.");
  CHECK(failure("\"motions\": [" + right + ", " + right + "]") ==
        "a.json: cloths[0].motions[1] holds node 3, which motions[0] holds too; a node follows one motion.");
}
