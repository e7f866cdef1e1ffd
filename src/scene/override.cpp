#include "scene/override.hpp"

#include <algorithm>
#include <cctype>

#include "base/json.hpp"

namespace weft::scene {
namespace {

/// "cloths[0].grid" and "cloths.0.grid" are cloths, 0, grid.
std::vector<std::string> split(const std::string& key) {
  std::vector<std::string> parts(1);
  for (std::size_t k = 0; k < key.size(); ++k) {
    if (key[k] == '.' || key[k] == '[')
      parts.emplace_back();
    else if (key[k] != ']')
      parts.back() += key[k];
  }
  return parts;
}

bool is_word(const std::string& text) {
  const auto inside = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_') &&
         std::all_of(text.begin(), text.end(), inside);
}

Result<Json> parse_value(const std::string& text) {
  auto parsed = parse_json(text, "the value " + in_quotes(text));
  if (parsed || !is_word(text)) return parsed;
  Json word;
  word.kind = Json::Kind::Text;
  word.text = text;
  return word;
}

/// The entry of a list or object that `part` names; made null in an object that lacks it.
Result<Json*> step(Json& json, const std::string& part, const std::string& path) {
  const std::string place = path.empty() ? "the scene" : path;
  if (json.kind == Json::Kind::List) {
    const bool digits = !part.empty() && part.size() < 10 &&
                        std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits)
      return input_error("%s is a list, and %s is not an index.", place.c_str(), in_quotes(part).c_str());
    const std::size_t index = std::stoul(part);
    if (index >= json.values.size())
      return input_error("%s has no entry %zu; it holds %zu, counted from 0.", place.c_str(), index,
                         json.values.size());
    return &json.values[index];
  }
  if (json.kind == Json::Kind::Null) json.kind = Json::Kind::Object;
  if (json.kind != Json::Kind::Object)
    return input_error("%s is %s, and has no %s in it.", place.c_str(), describe(json).c_str(),
                       in_quotes(part).c_str());
  if (Json* found = json.find(part)) return found;
  return &json.add(part, Json{});
}

void take_out(Json& object, const std::string& name) {
  const auto found = std::find(object.names.begin(), object.names.end(), name);
  object.values.erase(object.values.begin() + (found - object.names.begin()));
  object.names.erase(found);
}

Result<void> set(const Override& change, Json& scene) {
  const std::vector<std::string> parts = split(change.key);
  if (parts.size() > kMaxJsonNesting)
    return input_error("the key has %zu parts, more than the limit of %zu.", parts.size(), kMaxJsonNesting);
  if (std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); }))
    return input_error("a part of the key is empty.");
  WEFT_TRY(value, parse_value(change.value));
  Json* json = &scene;
  std::string path;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string& part = parts[k];
    const bool in_list = json->kind == Json::Kind::List;
    if (value.kind == Json::Kind::Null && json->kind == Json::Kind::Object) {
      if (json->find(part) == nullptr) return {};
      if (k + 1 == parts.size()) {
        take_out(*json, part);
        return {};
      }
    }
    WEFT_TRY(next, step(*json, part, path));
    path = in_list ? path + "[" + part + "]" : path_of_key(path, part);
    json = next;
  }
  *json = std::move(value);
  return {};
}

}  // namespace

Result<Override> parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return make_error(ErrorKind::Usage, "Option --set takes KEY=JSON, not %s.", in_quotes(text).c_str());
  return Override{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

Override override_solver(const std::string& kind) {
  std::string text = "{\"kind\": \"";
  for (const char c : kind) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) text += c;
  }
  return {"solver", text + "\"}"};
}

Result<void> apply(const Override& change, Json& scene) {
  auto done = set(change, scene);
  if (!done) return done.error().while_doing("setting " + in_quotes(change.key));
  return {};
}

}  // namespace weft::scene
