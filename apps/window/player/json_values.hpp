// Values of a scene's JSON by their dotted key, and as text again.
#pragma once

#include <string>
#include <vector>

#include "base/json.hpp"

namespace weft::window {

/// "cloths.0.grid" in its parts.
std::vector<std::string> parts_of(const std::string& key);
/// Whether a part is the number of a list's entry.
bool is_index(const std::string& part);

/// The value at a dotted key; null: there is none.
const Json* value_at(const Json& scene, const std::string& key);

/// A value as JSON.
std::string text_of(const Json& value);

}  // namespace weft::window
