// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace weft::mesh {

enum class PlyFormat { Text, BinaryLittle, BinaryBig };
enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(PlyType type);  // bytes, in a binary file
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type = PlyType::Uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;        // bytes, to the begin of the data
  std::size_t line_count = 0;  // in these bytes
};

/// Reads the header of a PLY file.
/// Errors  Input: what is wrong, with the line; more than 64 elements, or more than 64 properties in one.
/// Source  Turk, The PLY Polygon File Format, 1994.
Result<PlyHeader> read_ply_header(std::span<const std::byte> bytes);

}  // namespace weft::mesh
