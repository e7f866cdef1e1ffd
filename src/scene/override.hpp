// Changes to a scene's JSON before it is checked: `weft run SCENE --set cloths.0.grid=[128,128]`.
#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace weft {
struct Json;
}

namespace weft::scene {

/// Sets the value at a dotted key. Objects on the way are made where they are missing; list entries are not. Null takes
/// the key out of its object, so that the format's default holds.
struct Override {
  std::string key;    // "cloths.0.grid"; "cloths[0].grid", as messages write it, is the same
  std::string value;  // JSON, or a bare word that stands for a text: paper is "paper"
};

/// Splits KEY=JSON at the first equals sign.
/// Errors  Usage: there is none, or nothing stands before it.
Result<Override> parse_override(std::string_view text);

/// Replaces the whole solver object by {"kind": KIND}, so that all else has that kind's defaults.
Override override_solver(const std::string& kind);

/// Applies one change.
/// Errors  Input: the value is not JSON; a list has no such entry; a value on the way is no object or list.
Result<void> apply(const Override& change, Json& scene);

}  // namespace weft::scene
