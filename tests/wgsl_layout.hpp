// The layout of a WGSL struct of scalars and vec4s, by WGSL's own rules (§14.4.1), read from its text.
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

inline WgslLayout wgsl_layout(const std::string& text, const std::string& name) {
  static const std::map<std::string, std::uint32_t> kSizes = {
      {"f32", 4}, {"u32", 4}, {"i32", 4}, {"vec4f", 16}};
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
    const std::uint32_t size = kSizes.at(type);
    alignment = size > alignment ? size : alignment;
    layout.size = (layout.size + size - 1) / size * size;
    layout.offset[field] = layout.size;
    layout.size += size;
  }
  layout.size = (layout.size + alignment - 1) / alignment * alignment;
  return layout;
}

}  // namespace weft
