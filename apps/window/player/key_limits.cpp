#include "player/key_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "player/json_values.hpp"
#include "scene/schema.hpp"

namespace weft::window {
namespace {

const nlohmann::json& schema() {
  static const nlohmann::json parsed = nlohmann::json::parse(scene::schema_json());
  return parsed;
}

/// What stands beside a reference is of this key.
nlohmann::json resolved(const nlohmann::json& inner) {
  if (!inner.contains("$ref")) return inner;
  const std::string name = inner["$ref"].get<std::string>().substr(std::string("#/$defs/").size());
  nlohmann::json whole = schema().at("$defs").at(name);
  whole.update(inner);
  return whole;
}

/// The schema of a member, which may be that of one of several ways; null: there is none.
const nlohmann::json* member_of(const nlohmann::json& at, const std::string& part) {
  const auto in = [&](const nlohmann::json& way) -> const nlohmann::json* {
    return way.contains("properties") && way["properties"].contains(part) ? &way["properties"][part]
                                                                          : nullptr;
  };
  if (const nlohmann::json* found = in(at)) return found;
  for (const char* list : {"oneOf", "anyOf"})
    if (at.contains(list))
      for (const nlohmann::json& way : at[list])
        if (const nlohmann::json* found = in(way)) return found;
  return nullptr;
}

std::optional<nlohmann::json> schema_of(const std::string& key) {
  nlohmann::json at = schema();
  for (const std::string& part : parts_of(key)) {
    const nlohmann::json* inner =
        is_index(part) ? (at.contains("items") ? &at["items"] : nullptr) : member_of(at, part);
    if (inner == nullptr) return std::nullopt;
    at = resolved(nlohmann::json(*inner));
  }
  return at;
}

std::optional<KeyLimits> read_limits(const std::string& key) {
  const std::optional<nlohmann::json> found = schema_of(key);
  if (!found) return std::nullopt;
  KeyLimits limits;
  limits.meaning = found->value("description", "");
  const std::size_t open = limits.meaning.rfind('[');  // a description ends with its unit: "... [m]."
  if (open != std::string::npos && limits.meaning.size() > open + 2 &&
      limits.meaning.compare(limits.meaning.size() - 2, 2, "].") == 0) {
    limits.unit = limits.meaning.substr(open + 1, limits.meaning.size() - open - 3);
    limits.meaning = limits.meaning.substr(0, open == 0 ? 0 : open - 1) + ".";
  }
  const nlohmann::json ways = found->contains("anyOf") ? (*found)["anyOf"] : nlohmann::json::array({*found});
  for (const nlohmann::json& given : ways) {
    const nlohmann::json way = resolved(given);
    if (way.contains("enum"))
      for (const auto& word : way["enum"])
        if (word.is_string()) limits.choices.push_back(word);
    const nlohmann::json& number =
        way.value("type", "") == "array" && way.contains("items") ? way["items"] : way;
    if (limits.numeric || !number.contains("minimum") || !number.contains("maximum")) continue;
    limits.numeric = true;
    limits.least = number["minimum"];
    limits.most = number["maximum"];
    limits.whole = number.value("type", "") == "integer";
  }
  return limits;
}

}  // namespace

const std::optional<KeyLimits>& limits_of(const std::string& key) {
  static std::map<std::string, std::optional<KeyLimits>> read;
  const auto found = read.find(key);
  return found != read.end() ? found->second : read.emplace(key, read_limits(key)).first->second;
}

std::optional<Json> fallback_of(const std::string& key) {
  const std::optional<nlohmann::json> found = schema_of(key);
  if (!found || !found->contains("default")) return std::nullopt;
  auto value = parse_json((*found)["default"].dump(), "the schema");
  if (!value) return std::nullopt;
  return std::move(*value);
}

Result<std::string> parsed(const KeyLimits& limits, const std::string& label, const std::string& text) {
  const std::vector<std::string>& words = limits.choices;
  if (text.empty() && !words.empty()) return json_text(words.front());
  if (std::find(words.begin(), words.end(), text) != words.end()) return json_text(text);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool number = !text.empty() && *end == '\0';
  if (number && value >= limits.least && value <= limits.most &&
      (!limits.whole || value == std::floor(value)))
    return number_text(value);
  std::string must = std::string(limits.whole ? "a whole number from " : "a number from ") +
                     number_text(limits.least) + " to " + number_text(limits.most) +
                     (limits.unit.empty() ? "" : " " + limits.unit);
  for (const std::string& word : words) must += " or \"" + word + "\"";
  return input_error("%s is %s, but must be %s.", label.c_str(), in_quotes(text).c_str(), must.c_str());
}

}  // namespace weft::window
