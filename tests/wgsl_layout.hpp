// The layout of a WGSL struct of scalars, vec4s and arrays of vec4f, by WGSL's own rules (§14.4.1), read from
// its text.
#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>

namespace weft {

struct WgslLayout {
  std::map<std::string, std::uint32_t> offset;
  std::uint32_t size = 0;
};

/// The value of `const NAME = 4u;`, where `name` begins with NAME.
inline std::uint32_t wgsl_constant(const std::string& text, const std::string& name) {
  const std::string word = name.substr(0, name.find_first_of("> "));
  const std::size_t at = text.find("const " + word + " = ");
  return static_cast<std::uint32_t>(std::stoul(text.substr(text.find("= ", at) + 2)));
}

inline WgslLayout wgsl_layout(const std::string& text, const std::string& name) {
  static const std::map<std::string, std::uint32_t> kSizes = {
      {"f32", 4}, {"u32", 4}, {"i32", 4}, {"vec4f", 16}, {"vec4u", 16}};
  WgslLayout layout;
  const std::size_t begin = text.find("struct " + name + " {");
  std::istringstream lines(text.substr(begin, text.find("\n}", begin) - begin));
  std::string line;
  std::getline(lines, line);
  std::uint32_t alignment = 4;
  while (std::getline(lines, line)) {
    line = line.substr(0, line.find("//"));
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t first = line.find_first_not_of(' ');
    const std::string field = line.substr(first, line.find_first_of(" :", first) - first);
    const std::size_t type_begin = line.find_first_not_of(' ', colon + 1);
    const std::string type = line.substr(type_begin, line.find_first_of(" ,", type_begin) - type_begin);
    const bool array = type == "array<vec4f";
    const std::uint32_t element = array ? 16 : kSizes.at(type);
    const std::uint32_t count = array ? wgsl_constant(text, line.substr(line.find(", ") + 2)) : 1;
    alignment = element > alignment ? element : alignment;
    layout.size = (layout.size + element - 1) / element * element;
    layout.offset[field] = layout.size;
    layout.size += count * element;
  }
  layout.size = (layout.size + alignment - 1) / alignment * alignment;
  return layout;
}

}  // namespace weft
