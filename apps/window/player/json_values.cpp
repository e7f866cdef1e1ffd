#include "player/json_values.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace weft::window {

std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  std::istringstream words(key);
  for (std::string part; std::getline(words, part, '.');) parts.push_back(part);
  return parts;
}

bool is_index(const std::string& part) {
  return std::all_of(part.begin(), part.end(),
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

const Json* value_at(const Json& scene, const std::string& key) {
  const Json* at = &scene;
  for (const std::string& part : parts_of(key)) {
    if (at->kind == Json::Kind::List && is_index(part)) {
      const std::size_t index = std::stoul(part);
      at = index < at->values.size() ? &at->values[index] : nullptr;
    } else {
      at = at->kind == Json::Kind::Object ? at->find(part) : nullptr;
    }
    if (at == nullptr) return nullptr;
  }
  return at;
}

std::string text_of(const Json& value) {
  const auto joined = [&](char open, char close) {
    std::string text(1, open);
    for (std::size_t i = 0; i < value.values.size(); ++i) {
      if (i > 0) text += ",";
      if (!value.names.empty()) text += json_text(value.names[i]) + ":";
      text += text_of(value.values[i]);
    }
    return text + close;
  };
  switch (value.kind) {
    case Json::Kind::Null:
      break;
    case Json::Kind::Boolean:
      return value.boolean ? "true" : "false";
    case Json::Kind::Number:
      return number_text(value.number);
    case Json::Kind::Text:
      return json_text(value.text);
    case Json::Kind::List:
      return joined('[', ']');
    case Json::Kind::Object:
      return joined('{', '}');
  }
  return "null";
}

}  // namespace weft::window
