#include "player/scene_values.hpp"

#include <algorithm>

#include "player/json_values.hpp"
#include "player/key_limits.hpp"
#include "player/lists.hpp"

namespace weft::window {

Result<SceneValues> SceneValues::read(const SceneText& scene, const Changes& changes) {
  SceneValues made;
  WEFT_SET(made.scene_, parse_json(scene.text, scene.file));
  for (const scene::Override& change : scene.changes) WEFT_CHECK(scene::apply(change, made.scene_));
  for (const auto& [key, value] : changes) WEFT_CHECK(made.set(key, value));
  return made;
}

const Json* SceneValues::own(const std::string& key) const {
  if (const Json* given = value_at(scene_, key)) return given;
  return fallback(key);
}

const Json* SceneValues::fallback(const std::string& key) const {
  auto found = fallbacks_.find(key);
  if (found == fallbacks_.end()) found = fallbacks_.emplace(key, fallback_of(key)).first;
  return found->second ? &*found->second : nullptr;
}

const Json* SceneValues::now(const std::string& key) const {
  const auto found = changes_.find(key);
  if (found != changes_.end()) return &found->second;
  return is_cleared(key) ? fallback(key) : own(key);
}

std::vector<std::string> SceneValues::cleared() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : changes_)
    for (const std::string& gone : cleared_by(key))
      if (!changed(gone) && std::find(keys.begin(), keys.end(), gone) == keys.end()) keys.push_back(gone);
  return keys;
}

bool SceneValues::is_cleared(const std::string& key) const {
  for (const auto& [chosen, value] : changes_)
    if (chosen != key && is_within(key, chosen)) return true;
  const std::vector<std::string> gone = cleared();
  return std::any_of(gone.begin(), gone.end(),
                     [&](const std::string& other) { return is_within(key, other); });
}

Result<void> SceneValues::set(const std::string& key, const std::optional<std::string>& value) {
  changes_.erase(key);
  if (value) WEFT_SET(changes_[key], parse_json(*value, key));
  return {};
}

}  // namespace weft::window
