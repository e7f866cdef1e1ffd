#include "player/scene_values.hpp"

#include "player/json_values.hpp"
#include "player/key_limits.hpp"

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
  auto found = fallbacks_.find(key);
  if (found == fallbacks_.end()) found = fallbacks_.emplace(key, fallback_of(key)).first;
  return found->second ? &*found->second : nullptr;
}

const Json* SceneValues::now(const std::string& key) const {
  const auto found = changes_.find(key);
  return found != changes_.end() ? &found->second : own(key);
}

Result<void> SceneValues::set(const std::string& key, const std::optional<std::string>& value) {
  changes_.erase(key);
  if (value) WEFT_SET(changes_[key], parse_json(*value, key));
  return {};
}

}  // namespace weft::window
