#include "schema_validator.hpp"

#include <algorithm>
#include <cmath>

namespace weft::scene {
namespace {

using Kind = Json::Kind;

bool equal(const Json& a, const Json& b) {
  return a.kind == b.kind && a.boolean == b.boolean && a.number == b.number && a.text == b.text &&
         a.names == b.names &&
         std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), equal);
}

bool of_type(const Json& value, const std::string& type) {
  if (type == "string") return value.kind == Kind::Text;
  if (type == "array") return value.kind == Kind::List;
  if (type == "object") return value.kind == Kind::Object;
  if (type == "boolean") return value.kind == Kind::Boolean;
  if (type == "integer") return value.kind == Kind::Number && value.number == std::floor(value.number);
  return type == "number" && value.kind == Kind::Number;
}

double characters(const std::string& text) {
  return static_cast<double>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool keyword_holds(const Json& value, const std::string& word, const Json& rule, const Json& schema,
                   const Json& root, std::string& unknown) {
  const auto holds = [&](const Json& inner) { return valid(value, inner, root, unknown); };
  const auto count = static_cast<double>(value.values.size());
  const bool list = value.kind == Kind::List, object = value.kind == Kind::Object,
             number = value.kind == Kind::Number;
  const bool text = value.kind == Kind::Text;
  if (word == "title" || word == "description" || word == "default" || word == "$defs" || word == "$schema")
    return true;
  if (word == "$ref")
    return holds(*root.find("$defs")->find(rule.text.substr(std::string("#/$defs/").size())));
  if (word == "type") return of_type(value, rule.text);
  if (word == "const") return equal(value, rule);
  if (word == "enum")
    return std::any_of(rule.values.begin(), rule.values.end(),
                       [&](const Json& one) { return equal(value, one); });
  if (word == "not") return !holds(rule);
  if (word == "allOf") return std::all_of(rule.values.begin(), rule.values.end(), holds);
  if (word == "anyOf") return std::any_of(rule.values.begin(), rule.values.end(), holds);
  if (word == "oneOf") return std::count_if(rule.values.begin(), rule.values.end(), holds) == 1;
  if (word == "minimum") return !number || value.number >= rule.number;
  if (word == "maximum") return !number || value.number <= rule.number;
  if (word == "minLength") return !text || characters(value.text) >= rule.number;
  if (word == "maxLength") return !text || characters(value.text) <= rule.number;
  if (word == "minItems") return !list || count >= rule.number;
  if (word == "maxItems") return !list || count <= rule.number;
  if (word == "items")
    return !list || std::all_of(value.values.begin(), value.values.end(),
                                [&](const Json& item) { return valid(item, rule, root, unknown); });
  if (word == "prefixItems") {
    for (std::size_t k = 0; list && k < std::min(value.values.size(), rule.values.size()); ++k)
      if (!valid(value.values[k], rule.values[k], root, unknown)) return false;
    return true;
  }
  if (word == "required")
    return !object || std::all_of(rule.values.begin(), rule.values.end(),
                                  [&](const Json& key) { return value.find(key.text); });
  if (word == "dependentRequired") {
    for (std::size_t k = 0; object && k < rule.names.size(); ++k)
      for (const Json& needed : rule.values[k].values)
        if (value.find(rule.names[k]) && !value.find(needed.text)) return false;
    return true;
  }
  if (word == "properties") {
    for (std::size_t k = 0; object && k < rule.names.size(); ++k)
      if (const Json* inner = value.find(rule.names[k]);
          inner && !valid(*inner, rule.values[k], root, unknown))
        return false;
    return true;
  }
  if (word == "additionalProperties")
    return !object || rule.boolean ||
           std::all_of(value.names.begin(), value.names.end(),
                       [&](const std::string& name) { return schema.find("properties")->find(name); });
  unknown += word + " ";
  return false;
}

}  // namespace

bool valid(const Json& value, const Json& schema, const Json& root, std::string& unknown) {
  for (std::size_t k = 0; k < schema.names.size(); ++k)
    if (!keyword_holds(value, schema.names[k], schema.values[k], schema, root, unknown)) return false;
  return true;
}

}  // namespace weft::scene
