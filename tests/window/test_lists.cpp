#include "player/lists.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "player/key_limits.hpp"
#include "source_path.hpp"

using namespace weft;
using namespace weft::window;

TEST_CASE("the schema knows each key of the list that page and window share, and what it allows") {
  std::set<std::string> seen;
  for (const ParameterGroup& group : parameter_groups()) {
    CHECK(!group.parameters.empty());
    for (const Parameter& each : group.parameters) {
      CAPTURE(each.key);
      CHECK(seen.insert(each.key).second);
      const auto limits = limits_of(each.key);
      REQUIRE(limits);
      CHECK((limits->numeric ? limits->least < limits->most : limits->choices.size() > 1));
      CHECK(!limits->meaning.empty());
      CHECK((each.reach > 0) == (group.live && limits->numeric && each.key != "cloths.0.color"));
      for (const std::string& gone : each.clears) CHECK(limits_of(gone));
    }
  }
  CHECK(seen.size() == 29);
}

TEST_CASE("the shared list of scenes names scenes that are shipped, each once") {
  std::set<std::string> seen;
  for (const SceneGroup& group : scene_groups())
    for (const SceneEntry& each : group.scenes) {
      CAPTURE(each.name);
      CHECK(seen.insert(each.name).second);
      CHECK(std::filesystem::exists(source_path("scenes/" + each.name + ".json")));
    }
  CHECK(seen.count("hanging") == 1);
}

TEST_CASE("only what a cloth has can be asked for") {
  const auto given = [](std::set<std::string> keys) {
    return [keys = std::move(keys)](const std::string& key) { return keys.count(key) > 0; };
  };
  CHECK(applies("gravity", given({})));
  CHECK(applies("cloths.0.damping", given({})));
  CHECK(!applies("cloths.0.damping", given({"cloths.0.fabric"})));
  CHECK(!applies("cloths.0.density", given({"cloths.0.node_mass"})));
  CHECK(applies("cloths.0.node_mass", given({"cloths.0.node_mass"})));
  CHECK(!applies("cloths.0.fabric.warp", given({"cloths.0.fabric"})));
  CHECK(applies("cloths.0.fabric", given({"cloths.0"})));
  CHECK(!applies("cloths.0.look", given({})));
  CHECK(applies("colliders.1.material", given({"colliders.1"})));
  CHECK(!applies("colliders.1.material", given({"colliders.0"})));
  CHECK(!applies("air.density", given({})));
  CHECK(applies("air.density", given({"air"})));
}
