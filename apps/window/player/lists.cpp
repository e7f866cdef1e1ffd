#include "player/lists.hpp"

#include <nlohmann/json.hpp>

#include "shared_lists.hpp"

namespace weft::window {
namespace {

std::vector<ParameterGroup> read_parameters() {
  std::vector<ParameterGroup> groups;
  const nlohmann::json list = nlohmann::json::parse(kParameters);
  for (const auto& group : list.at("groups")) {
    ParameterGroup& made = groups.emplace_back();
    made.name = group.at("name");
    made.title = group.at("title");
    made.live = group.at("live");
    for (const auto& each : group.at("parameters"))
      made.parameters.push_back({each.at("key"), each.at("label"), each.value("reach", 0.0),
                                 each.value("clears", std::vector<std::string>())});
  }
  return groups;
}

std::vector<SceneGroup> read_scenes() {
  std::vector<SceneGroup> groups;
  const nlohmann::json list = nlohmann::json::parse(kScenes);
  for (const auto& group : list.at("groups")) {
    SceneGroup& made = groups.emplace_back();
    made.title = group.at("title");
    for (const auto& each : group.at("scenes")) made.scenes.push_back({each.at("name"), each.at("title")});
  }
  return groups;
}

}  // namespace

const std::vector<ParameterGroup>& parameter_groups() {
  static const std::vector<ParameterGroup> groups = read_parameters();
  return groups;
}

const std::vector<std::string>& cleared_by(const std::string& key) {
  static const std::vector<std::string> nothing;
  for (const ParameterGroup& group : parameter_groups())
    for (const Parameter& each : group.parameters)
      if (each.key == key) return each.clears;
  return nothing;
}

bool is_within(const std::string& key, const std::string& other) {
  return key == other || key.rfind(other + ".", 0) == 0;
}

bool applies(const std::string& key, const std::function<bool(const std::string&)>& now) {
  const auto begins = [&](const char* start) { return key.rfind(start, 0) == 0; };
  if (key == "air.density") return now("air");
  if (key == "cloths.0.fabric" || key == "cloths.0.look" || key == "cloths.0.color") return now("cloths.0");
  if (begins("colliders.")) return now(key.substr(0, key.rfind('.')));
  if (begins("cloths.0.stiffness.") || begins("cloths.0.damping")) return !now("cloths.0.fabric");
  const bool given = key == "cloths.0.density" || key == "cloths.0.node_mass" || begins("cloths.0.fabric.");
  return !given || now(key);
}

const std::vector<SceneGroup>& scene_groups() {
  static const std::vector<SceneGroup> groups = read_scenes();
  return groups;
}

}  // namespace weft::window
