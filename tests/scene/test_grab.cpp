#include <doctest/doctest.h>

#include "scene/grab.hpp"
#include "scene/load.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Grab between(double start, const std::optional<double>& end) {
  Grab grab;
  grab.start = start;
  grab.end = end;
  return grab;
}

}  // namespace

TEST_CASE("a grab pulls to its first point, then straight along its path, then to its last") {
  Grab grab;
  grab.path = {{1, {1, 0, 0}}, {3, {1, 4, 0}}};
  CHECK(target_at(grab, -1) == Vec3d{1, 0, 0});
  CHECK(target_at(grab, 1) == Vec3d{1, 0, 0});
  CHECK(target_at(grab, 1.5) == Vec3d{1, 1, 0});
  CHECK(target_at(grab, 3) == Vec3d{1, 4, 0});
  CHECK(target_at(grab, 99) == Vec3d{1, 4, 0});
}

TEST_CASE("a grab holds in the substeps that end after its start and not after its end") {
  const Grab grab = between(1, 2.0);
  CHECK_FALSE(active_at(grab, 1));
  CHECK(active_at(grab, 1.001));
  CHECK(active_at(grab, 2));
  CHECK_FALSE(active_at(grab, 2.001));
  CHECK(active_at(between(1, {}), 1e6));
  CHECK_FALSE(overlap(grab, between(2, {})));
  CHECK(overlap(grab, between(1.9, {})));
}

TEST_CASE("of grabs that follow each other the most at once count, and from when on they are") {
  CHECK(most_at_once({}).count == 0);
  const MostAtOnce chain = most_at_once({{2, 3}, {0, 1}, {1, 2}});
  CHECK(chain.count == 1);
  const MostAtOnce most = most_at_once({{0, 9}, {5, 6}, {4, 5}, {4.5, 7}, {8, 20}});
  CHECK(most.count == 3);
  CHECK(most.time == 4.5);
}

TEST_CASE("1024 nodes can be grabbed at once, and more over time") {
  const auto grabs = [](int count, const std::string& last) {
    std::string text;
    for (int k = 0; k < count; ++k)
      text += R"({"node": {"nodes": [)" + std::to_string(k) +
              R"(]}, "start": 1, "end": 3, "path": [{"time": 0, "point": [0, 0, 0]}]}, )";
    return cloth_with(R"("grabs": [)" + text + R"({"node": "top_right", )" + last +
                      R"("path": [{"time": 0, "point": [0, 0, 0]}]}])");
  };
  CHECK(parse_scene(grabs(1023, ""), "a.json"));
  CHECK(parse_scene(grabs(1024, R"("start": 3, )"), "a.json"));
  CHECK(parse_scene(grabs(1024, R"("end": 1, )"), "a.json"));
  const auto refused = parse_scene(grabs(1024, R"("start": 2, )"), "a.json");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message == "a.json: at 2 s grabs hold 1025 nodes; the limit is 1024 at once.");
}
