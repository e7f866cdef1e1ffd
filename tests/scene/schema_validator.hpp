// A validator for as much of JSON Schema 2020-12 as schema_json() uses; any other keyword is an error of its
// own.
#pragma once

#include <string>

#include "base/json.hpp"

namespace weft::scene {

/// Whether `value` is valid under `schema`, a part of `root`. `unknown` gathers keywords that are not
/// understood.
bool valid(const Json& value, const Json& schema, const Json& root, std::string& unknown);

}  // namespace weft::scene
