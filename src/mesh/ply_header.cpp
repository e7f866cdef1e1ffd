#include "mesh/ply_header.hpp"

#include <optional>

#include "mesh/number.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {
namespace {

constexpr std::size_t kMaxElements = 64;
constexpr std::size_t kMaxProperties = 64;

Result<PlyType> read_type(TextCursor& cursor) {
  static constexpr struct {
    std::string_view name;
    PlyType type;
  } kTypes[] = {{"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
                {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
                {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
                {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
                {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
                {"float64", PlyType::Float64}};
  const std::string_view word = cursor.next_in_line();
  for (const auto& row : kTypes)
    if (row.name == word) return row.type;
  return input_error("Line %zu has \"%s\" where a type such as uchar, int or float is due.", cursor.line(),
                     quoted(word).c_str());
}

Result<PlyFormat> read_format(TextCursor& cursor) {
  const std::string_view name = cursor.next_in_line();
  const std::string_view version = cursor.next_in_line();
  if (version != "1.0")
    return input_error("Line %zu names version \"%s\" of PLY, not 1.0.", cursor.line(),
                       quoted(version).c_str());
  if (name == "ascii") return PlyFormat::Text;
  if (name == "binary_little_endian") return PlyFormat::BinaryLittle;
  if (name == "binary_big_endian") return PlyFormat::BinaryBig;
  return input_error("Line %zu names format \"%s\", not ascii, binary_little_endian or binary_big_endian.",
                     cursor.line(), quoted(name).c_str());
}

Result<PlyElement> read_element(TextCursor& cursor) {
  PlyElement element;
  const std::string_view name = cursor.next_in_line();
  const std::string_view word = cursor.next_in_line();
  const auto count = parse_integer(word);
  if (!count || *count < 0)
    return input_error("Line %zu gives element \"%s\" the count \"%s\", which is not a number from 0.",
                       cursor.line(), quoted(name).c_str(), quoted(word).c_str());
  element.name = std::string(name);
  element.count = static_cast<std::uint64_t>(*count);
  return element;
}

Result<PlyProperty> read_property(TextCursor& cursor) {
  PlyProperty property;
  TextCursor after_type = cursor;
  if (after_type.next_in_line() == "list") {
    cursor = after_type;
    property.is_list = true;
    WEFT_TRY(count_type, read_type(cursor));
    if (!is_integer(count_type))
      return input_error("Line %zu counts a list in a type that is not an integer.", cursor.line());
    property.count_type = count_type;
  }
  WEFT_TRY(type, read_type(cursor));
  property.type = type;
  property.name = std::string(cursor.next_in_line());
  if (property.name.empty()) return input_error("Line %zu has a property without a name.", cursor.line());
  return property;
}

// One line of the header but the first and the last.
Result<void> read_line(TextCursor& cursor, std::string_view keyword, std::optional<PlyFormat>& format,
                       std::vector<PlyElement>& elements) {
  if (keyword == "comment" || keyword == "obj_info") return {};
  if (keyword == "format") {
    WEFT_TRY(read, read_format(cursor));
    format = read;
    return {};
  }
  if (keyword == "element") {
    if (elements.size() == kMaxElements)
      return input_error("Line %zu has element number %zu, over the limit of %zu.", cursor.line(),
                         kMaxElements + 1, kMaxElements);
    WEFT_TRY(element, read_element(cursor));
    for (const PlyElement& other : elements)
      if (other.name == element.name)
        return input_error("Line %zu names element \"%s\" for the second time.", cursor.line(),
                           quoted(element.name).c_str());
    elements.push_back(std::move(element));
    return {};
  }
  if (keyword == "property") {
    if (elements.empty())
      return input_error("Line %zu has a property before the first element.", cursor.line());
    if (elements.back().properties.size() == kMaxProperties)
      return input_error("Line %zu has property number %zu of its element, over the limit of %zu.",
                         cursor.line(), kMaxProperties + 1, kMaxProperties);
    WEFT_TRY(property, read_property(cursor));
    elements.back().properties.push_back(std::move(property));
    return {};
  }
  return input_error("Line %zu begins with \"%s\", which is no keyword of a PLY header.", cursor.line(),
                     quoted(keyword).c_str());
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
      return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
      return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      break;
  }
  return 8;
}

bool is_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes) {
  TextCursor cursor(bytes, {});
  PlyHeader header;
  std::optional<PlyFormat> format;
  if (const std::string_view word = cursor.next_in_line(); word != "ply")
    return input_error("The file begins with \"%s\", not with ply.", quoted(word).c_str());
  while (cursor.next_filled_line()) {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword != "end_header") {
      WEFT_CHECK(read_line(cursor, keyword, format, header.elements));
      continue;
    }
    if (!format) return input_error("The header ends on line %zu without a format.", cursor.line());
    header.format = *format;
    cursor.next_line();
    header.size = cursor.position();
    header.line_count = cursor.line() - 1;
    return header;
  }
  return input_error("The file ends on line %zu, before end_header.", cursor.line());
}

}  // namespace weft::mesh
