// Checks a JSON value against the table of format.hpp.
#pragma once

#include <string>

#include "base/json.hpp"
#include "base/result.hpp"
#include "scene/format.hpp"

namespace weft::scene {

/// Checks `json`, which stands at `path`, against `type`, and adds the defaults of the keys that it lacks.
/// Errors  Input: the first departure found, with file, JSON path, value and limit.
Result<void> check(Json& json, const Type& type, const std::string& file, const std::string& path = "");

/// The JSON type of all values of a type that is not Either.
Json::Kind json_kind(const Type& type);

/// Whether a key of an object names a fabric: it is a text, or an object that has "name". `key` may be null.
bool names_fabric(const Json& object, const char* key);

/// The keys that an object may have: the common ones, then those of its variant (of all, if it names none).
std::vector<const Key*> keys_of(const Type& type, const Json& json);

}  // namespace weft::scene
