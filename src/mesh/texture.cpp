#include "mesh/texture.hpp"

#include <cmath>

#include "mesh/number.hpp"
#include "mesh/ply_values.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

using Pairs = std::vector<std::array<float, 2>>;

Result<Pairs> texture_of_obj(std::span<const std::byte> bytes) {
  Pairs pairs;
  TextCursor cursor(bytes, {.comments = true, .continuations = true});
  do {
    if (cursor.next_in_line() != "vt") continue;
    const auto u = parse_float(cursor.next_in_line()), v = parse_float(cursor.next_in_line());
    if (!u || !v) return input_error("Line %zu has \"vt\" without two numbers.", cursor.line());
    pairs.push_back({*u, *v});
  } while (cursor.next_line());
  return pairs;
}

Result<Pairs> texture_of_ply(std::span<const std::byte> bytes) {
  WEFT_TRY(header, read_ply_header(bytes));
  Pairs pairs;
  if (header.format == PlyFormat::Text || header.elements.empty() || header.elements[0].name != "vertex")
    return pairs;  // not as write_ply writes it
  const PlyElement& vertex = header.elements[0];
  PlyBinaryValues values(bytes, header);
  for (std::uint64_t row = 0; row < vertex.count; ++row) {
    std::array<float, 2> pair{};
    int found = 0;
    for (const PlyProperty& property : vertex.properties) {
      if (property.is_list) return Pairs();
      WEFT_TRY(value, values.read(property.type));
      if (property.name != "s" && property.name != "t") continue;
      pair[property.name == "s" ? 0 : 1] = static_cast<float>(value);
      ++found;
    }
    if (found != 2) return Pairs();
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

Result<Pairs> read_texture(std::span<const std::byte> bytes, const std::string& name, std::size_t vertices) {
  const bool obj = name.size() > 4 && same_word(std::string_view(name).substr(name.size() - 4), ".obj");
  WEFT_TRY(pairs, obj ? texture_of_obj(bytes) : texture_of_ply(bytes));
  if (pairs.size() != vertices) pairs.clear();
  for (std::size_t v = 0; v < pairs.size(); ++v)
    if (!std::isfinite(pairs[v][0]) || !std::isfinite(pairs[v][1]))
      return input_error("The texture coordinates (%g, %g) of vertex %zu are not finite.",
                         static_cast<double>(pairs[v][0]), static_cast<double>(pairs[v][1]), v);
  return pairs;
}

}  // namespace weft::mesh
