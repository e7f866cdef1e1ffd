// The allowed values of a scene's keys, from the schema: what a field of the panel has to know.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"

namespace weft::window {

struct KeyLimits {
  std::string unit;                  // "m/s²"; empty for a plain number
  std::string meaning;               // a sentence
  std::vector<std::string> choices;  // words that may stand there
  bool numeric = false;              // whether a number may, or a list of them
  double least = 0, most = 0;
  bool whole = false;
};

/// What the schema says of a dotted key; none: scenes have no such key. It is asked for in each picture, and kept.
const std::optional<KeyLimits>& limits_of(const std::string& key);
/// The value that a key has where a scene does not give it, as JSON; none: it must be given, or is left out.
std::optional<Json> fallback_of(const std::string& key);

/// What was typed for a key that is a number, or a word that stands for one, as JSON; nothing is the first such word.
/// Errors  Input: it is neither, as a sentence that says what `label` must be.
Result<std::string> parsed(const KeyLimits& limits, const std::string& label, const std::string& text);

}  // namespace weft::window
