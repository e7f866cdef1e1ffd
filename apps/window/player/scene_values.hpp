#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "session/session.hpp"

namespace weft::window {

/// JSON by dotted key.
using Changes = std::map<std::string, std::string>;

/// What the keys of a scene are: in its file, by the format, and as the panel has changed them.
class SceneValues {
 public:
  /// Errors  Input: a text is not JSON, or a change of the command line does not fit.
  static Result<SceneValues> read(const SceneText& scene, const Changes& changes);

  /// The value that the scene's file or the format has; null: neither.
  const Json* own(const std::string& key) const;
  /// The same, with what the panel has changed and what that takes out of the scene.
  const Json* now(const std::string& key) const;
  /// What it takes out.
  std::vector<std::string> cleared() const;
  bool changed(const std::string& key) const { return changes_.count(key) > 0; }
  /// Changes a key; none: as the scene has it. Errors  Input: it is not JSON.
  Result<void> set(const std::string& key, const std::optional<std::string>& value);

 private:
  bool is_cleared(const std::string& key) const;
  const Json* fallback(const std::string& key) const;

  Json scene_;                           // with what the command line changes
  std::map<std::string, Json> changes_;  // of the panel
  mutable std::map<std::string, std::optional<Json>> fallbacks_;
};

}  // namespace weft::window
