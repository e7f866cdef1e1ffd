#pragma once

#include <nlohmann/json.hpp>

namespace weft {

using Json = nlohmann::ordered_json;

/// Every struct that mirrors one of WGSL: its name there, the shader, the bytes, and each member but padding.
Json struct_layouts();
/// Every number that stands in both languages: its name in WGSL, the shader, the value in C++.
Json shared_constants();
/// Every enumeration that gpu_backend.ts knows by number: its enumerators and their values.
Json enum_values();

}  // namespace weft
