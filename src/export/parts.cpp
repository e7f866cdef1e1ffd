#include "export/parts.hpp"

#include <cmath>
#include <cstdio>
#include <set>

#include "base/json.hpp"

namespace weft {
namespace {

constexpr const char* kFormat = "weft-meshes/1";

Result<double> number(const Json& object, const std::string& place, const char* name, double least,
                      double most) {
  const Json* value = object.find(name);
  if (value == nullptr) return input_error("%s is missing.", place.c_str());
  if (value->kind != Json::Kind::Number || !(value->number >= least && value->number <= most))
    return input_error("%s is %s, not a number from %s to %s.", place.c_str(), describe(*value).c_str(),
                       number_text(least).c_str(), number_text(most).c_str());
  return value->number;
}

Result<std::uint32_t> whole(const Json& object, const std::string& path, const char* name) {
  const std::string place = path_of_key(path, name);
  WEFT_TRY(value, number(object, place, name, 1, 4294967295.0));
  if (value != std::floor(value))
    return input_error("%s is %s, not a whole number.", place.c_str(), number_text(value).c_str());
  return static_cast<std::uint32_t>(value);
}

Result<mesh::MeshPart> read_part(const Json& json, const std::string& path) {
  if (json.kind != Json::Kind::Object)
    return input_error("%s is %s, not an object.", path.c_str(), describe(json).c_str());
  mesh::MeshPart part;
  const Json* name = json.find("name");
  if (name == nullptr || name->kind != Json::Kind::Text || name->text.empty())
    return input_error("%s has no name.", path.c_str());
  part.name = name->text;
  WEFT_SET(part.vertices, whole(json, path, "vertices"));
  WEFT_SET(part.triangles, whole(json, path, "triangles"));
  const Json* color = json.find("color");
  if (color == nullptr) return part;
  Vec3d rgb;
  if (color->kind != Json::Kind::List || color->values.size() != 3)
    return input_error("%s.color is %s, not a list of 3.", path.c_str(), describe(*color).c_str());
  for (int axis = 0; axis < 3; ++axis) {
    const Json& value = color->values[static_cast<std::size_t>(axis)];
    if (value.kind != Json::Kind::Number || !(value.number >= 0 && value.number <= 1))
      return input_error("%s.color has %s, not a number from 0 to 1.", path.c_str(), describe(value).c_str());
    rgb[axis] = value.number;
  }
  part.color = rgb;
  return part;
}

}  // namespace

void name_apart(std::vector<mesh::MeshPart>& parts) {
  std::set<std::string> taken;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::string wanted = parts[p].name.empty() ? "cloth_" + std::to_string(p) : parts[p].name;
    parts[p].name = wanted;
    for (int k = 2; !taken.insert(parts[p].name).second; ++k)
      parts[p].name = wanted + "_" + std::to_string(k);
  }
}

std::string parts_json(const MeshParts& parts) {
  std::string text = R"({"format": ")" + std::string(kFormat) + R"(", "frame_s": )" +
                     number_text(parts.frame) + ", \"parts\": [";
  for (std::size_t p = 0; p < parts.parts.size(); ++p) {
    const mesh::MeshPart& part = parts.parts[p];
    text += (p > 0 ? ",\n" : "\n") + (R"(  {"name": )" + json_text(part.name)) + R"(, "vertices": )" +
            std::to_string(part.vertices) + R"(, "triangles": )" + std::to_string(part.triangles);
    if (part.color)
      text += R"(, "color": [)" + number_text(part.color->x) + ", " + number_text(part.color->y) + ", " +
              number_text(part.color->z) + "]";
    text += "}";
  }
  return text + "\n]}\n";
}

Result<MeshParts> read_parts(const std::string& text, const std::string& file) {
  WEFT_TRY(json, parse_json(text, file));
  const Json* format = json.find("format");
  if (format == nullptr || format->kind != Json::Kind::Text || format->text != kFormat)
    return input_error("File %s has no \"format\": \"%s\".", file.c_str(), kFormat);
  MeshParts made;
  const std::string in_file = "In file " + file + ", ";
  const Json* list = json.find("parts");
  if (list == nullptr || list->kind != Json::Kind::List || list->values.empty())
    return input_error("%sparts is no list of parts.", in_file.c_str());
  WEFT_SET(made.frame, number(json, in_file + "frame_s", "frame_s", 1e-9, 1e9));
  std::set<std::string> names;
  for (std::size_t p = 0; p < list->values.size(); ++p) {
    WEFT_TRY(part, read_part(list->values[p], in_file + path_of_index("parts", p)));
    if (!names.insert(part.name).second)
      return input_error("%stwo parts have the name %s.", in_file.c_str(), in_quotes(part.name).c_str());
    made.parts.push_back(std::move(part));
  }
  return made;
}

}  // namespace weft
