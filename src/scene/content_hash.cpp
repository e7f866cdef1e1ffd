#include "scene/content_hash.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <string_view>

#include "base/state_hash.hpp"

namespace weft::scene {
namespace {

/// Keys that no motion follows from: at the top, in "time", and in the entries of "cloths", "bodies" and "colliders".
constexpr std::string_view kOfTop[] = {"format", "title", "description", "camera", "render"};
constexpr std::string_view kOfTime[] = {"frames"};
constexpr std::string_view kOfCloth[] = {"name", "color", "look"};
constexpr std::string_view kOfCollider[] = {"material"};

void append(std::string& text, const Json& value);

void append_members(std::string& text, const Json& object, std::span<const std::string_view> without) {
  std::vector<std::size_t> order(object.names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return object.names[a] < object.names[b]; });
  text += '{';
  for (const std::size_t member : order) {
    const std::string& name = object.names[member];
    if (std::find(without.begin(), without.end(), name) != without.end()) continue;
    text += std::to_string(name.size()) + ':' + name;
    const Json& value = object.values[member];
    const bool at_top = without.data() == kOfTop;
    if (at_top && name == "time") {
      append_members(text, value, kOfTime);
    } else if (at_top && (name == "cloths" || name == "bodies")) {
      for (const Json& entry : value.values) append_members(text, entry, kOfCloth);
      text += ';';
    } else if (at_top && name == "colliders") {
      text += '[';
      for (const Json& entry : value.values) append_members(text, entry, kOfCollider);
      text += ']';
    } else {
      append(text, value);
    }
  }
  text += '}';
}

/// No two values that differ are the same text.
void append(std::string& text, const Json& value) {
  switch (value.kind) {
    case Json::Kind::Null:
      text += 'n';
      break;
    case Json::Kind::Boolean:
      text += value.boolean ? 't' : 'f';
      break;
    case Json::Kind::Number:
      text += '#' + number_text(value.number);
      break;
    case Json::Kind::Text:
      text += '"' + std::to_string(value.text.size()) + ':' + value.text;
      break;
    case Json::Kind::List:
      text += '[';
      for (const Json& one : value.values) append(text, one);
      text += ']';
      break;
    case Json::Kind::Object:
      append_members(text, value, {});
      break;
  }
}

}  // namespace

std::uint64_t content_hash(const Json& scene) {
  std::string text;
  append_members(text, scene, kOfTop);
  return bytes_hash(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace weft::scene
