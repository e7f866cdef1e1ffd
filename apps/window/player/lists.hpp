// The lists that the window shares with the page: apps/shared/.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace weft::window {

struct Parameter {
  std::string key;  // dotted, of a scene
  std::string label;
  double reach = 0;                   // the least range of its slider, where it changes while the cloth moves
  std::vector<std::string> clears{};  // in whose place it stands: chosen, it takes them out of the scene
};
struct ParameterGroup {
  std::string name, title;
  bool live = false;  // whether its keys change while the cloth moves; else they restart the scene
  std::vector<Parameter> parameters;
};
const std::vector<ParameterGroup>& parameter_groups();
/// In whose place a key stands; nothing for most.
const std::vector<std::string>& cleared_by(const std::string& key);
/// Whether `key` is `other` or within it: cloths.0.fabric.warp is within cloths.0.fabric.
bool is_within(const std::string& key, const std::string& other);

/// A cloth has a density or a mass of its nodes, and is of springs or of a fabric, whose numbers may stand in its name;
/// a scene may be without air, cloth or obstacles. What it is not given, it cannot be asked for. `now`: whether the
/// scene or the format has a value of the key.
bool applies(const std::string& key, const std::function<bool(const std::string&)>& now);

struct SceneEntry {
  std::string name, title;
};
struct SceneGroup {
  std::string title;
  std::vector<SceneEntry> scenes;
};
const std::vector<SceneGroup>& scene_groups();

}  // namespace weft::window
