#include <doctest/doctest.h>

#include "scene/load.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

Result<Scene> with(const std::vector<Override>& overrides, const std::string& text = minimal_scene()) {
  return parse_scene(text, "a.json", overrides);
}

std::string failure(const std::string& key, const std::string& value) {
  const auto scene = with({{key, value}});
  REQUIRE_FALSE(scene);
  CHECK(scene.error().kind == ErrorKind::Input);
  return scene.error().message;
}

}  // namespace

TEST_CASE("an override replaces a value, in lists and objects, by dots or brackets") {
  CHECK(with({{"cloths.0.grid", "[128, 64]"}})->cloths[0].grid->nx == 128);
  CHECK(with({{"cloths.0.grid.1", "77"}})->cloths[0].grid->ny == 77);
  CHECK(with({{"cloths[0].grid[1]", "78"}})->cloths[0].grid->ny == 78);
  CHECK(with({{"gravity", "[0, 0, -1]"}})->gravity == Vec3d{0, 0, -1});
  CHECK(with({{"drag", " 0.5 "}})->drag == 0.5);
}

TEST_CASE("an override makes the objects that are missing on its way") {
  CHECK(with({{"time.frames", "12"}})->time.frames == 12);
  CHECK(with({{"cloths.0.transform.scale", "3"}})->cloths[0].transform.scale == 3);
  CHECK(with({{"cloths.0.stiffness.bend", "7"}})->cloths[0].stiffness.bend == 7);
  CHECK(with({{"cloths.0.stiffness.bend", "7"}})->cloths[0].stiffness.shear == 2000);
  CHECK(with({{"solver.forces", "spring_centric"}})->solver.forces == Forces::SpringCentric);
}

TEST_CASE("null takes a key out, whether it is there or not, and what is in a list stays") {
  const std::string full = scene_with(R"("drag": 2, "time": {"substeps": 3, "frames": 7})");
  CHECK(with({{"drag", "null"}}, full)->drag == 0);
  CHECK(with({{"time.substeps", "null"}}, full)->time.substeps == std::nullopt);
  CHECK(with({{"time.substeps", "null"}}, full)->time.frames == 7);
  CHECK(with({{"time", "null"}}, full)->time.frames == 90);
  CHECK(with({{"drag", "null"}, {"drag", "3"}}, full)->drag == 3);
  CHECK(with({{"cloths.0.look", "null"}, {"render.light.degrees", "null"}}, full));
  CHECK(failure("cloths.0", "null").find("cloths[0] is null") != std::string::npos);
  CHECK(failure("cloths.0.size", "null").find("size") != std::string::npos);
  const auto denim = with({{"cloths.0.stiffness", "null"},
                           {"cloths.0.damping", "null"},
                           {"cloths.0.density", "null"},
                           {"cloths.0.fabric", "denim_11oz"}});
  REQUIRE_MESSAGE(denim, (denim ? "" : denim.error().message));
  CHECK(denim->cloths[0].density == 0.324);
}

TEST_CASE("a bare word is a text, and only a word") {
  CHECK(with({{"contact.method", "paper"}})->contact.method == ContactMethod::Paper);
  CHECK(with({{"contact.method", "\"paper\""}})->contact.method == ContactMethod::Paper);
  CHECK(with({{"time.substeps", "auto"}}, scene_with(R"("time": {"substeps": 3})"))->time.substeps ==
        std::nullopt);
  CHECK(failure("title", "two words").find("While setting \"title\": the value \"two words\": line 1") == 0);
  CHECK(failure("title", "true").find("title is true, not a text") != std::string::npos);
  CHECK(failure("drag", "NaN").find("drag is the text \"NaN\", not a number") != std::string::npos);
  CHECK(failure("drag", "1e999").find("number overflow") != std::string::npos);
  CHECK(failure("drag", "").find("While setting \"drag\"") == 0);
}

TEST_CASE("overrides are applied in order, before the checks") {
  CHECK(with({{"drag", "-1"}, {"drag", "2"}})->drag == 2);
  CHECK(with({{"format", "weft-scene/1"}}).error().message.find("While setting") ==
        0);  // a slash is in no word
  CHECK(
      with({{"cloths.0.density", "0"}}).error().message.find("a.json: cloths[0].density is 0; it must be") ==
      0);
  CHECK(with({{"cloths.0.densty", "1"}}).error().message.find("did you mean \"density\"?") !=
        std::string::npos);
  CHECK(with({{"cloths", "[{\"mesh\": \"shirt\", \"density\": 1}]"}})->cloths[0].mesh == "shirt");
}

TEST_CASE("an override that leads nowhere says where it ends") {
  CHECK(failure("cloths.1.grid", "[4, 4]") ==
        "While setting \"cloths.1.grid\": cloths has no entry 1; it holds 1, counted from 0.");
  CHECK(failure("cloths.first.grid", "[4, 4]").find("cloths is a list, and \"first\" is not an index.") !=
        std::string::npos);
  CHECK(failure("cloths.-1.grid", "1").find("\"-1\" is not an index") != std::string::npos);
  CHECK(failure("cloths.99999999999999999999.grid", "1").find("is not an index") != std::string::npos);
  CHECK(failure("format.x", "1").find("format is the text \"weft-scene/1\", and has no \"x\" in it.") !=
        std::string::npos);
  CHECK(failure("cloths.0.grid.0.x", "1").find("cloths[0].grid[0] is 4, and has no \"x\" in it.") !=
        std::string::npos);
  CHECK(failure("time..frame", "1").find("a part of the key is empty") != std::string::npos);
  CHECK(failure("", "1").find("a part of the key is empty") != std::string::npos);
  CHECK(failure(std::string(100000, '.'), "1").find("more than the limit of 64") != std::string::npos);
  CHECK(with({{"a", "1"}}, "[]").error().message.find("the scene is a list, and \"a\" is not an index") !=
        std::string::npos);
}

TEST_CASE("a solver override replaces the whole solver object") {
  const std::string text = scene_with(R"("solver": {"kind": "mass_spring", "forces": "spring_centric"})");
  CHECK(with({override_solver("mass_spring")}, text)->solver.forces == Forces::NodeCentric);
  CHECK(with({override_solver("newton")}, text).error().message ==
        "a.json: solver.kind is \"newton\", not one of \"mass_spring\", \"multigrid\", \"xpbd\", \"pbd\", "
        "\"vbd\", "
        "\"projective_dynamics\", \"fem\", \"auto\".");
  CHECK(with({override_solver("a\"b\\c\n")}, text).error().kind == ErrorKind::Input);
}

TEST_CASE("KEY=JSON is split at its first equals sign") {
  CHECK(parse_override("title=a=b")->key == "title");
  CHECK(parse_override("title=a=b")->value == "a=b");
  CHECK(parse_override("drag=")->value.empty());
  CHECK(parse_override("drag").error().message == "Option --set takes KEY=JSON, not \"drag\".");
  CHECK(parse_override("=1").error().kind == ErrorKind::Usage);
}
