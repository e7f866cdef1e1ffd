// The numbers after a PLY header, one after the other, from text or bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/result.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/text_cursor.hpp"

namespace weft::mesh {

/// Values of a text PLY file. Lines have no meaning there but for messages.
class PlyTextValues {
 public:
  PlyTextValues(std::span<const std::byte> file, const PlyHeader& header);

  /// The next value; exact in double for every type.
  Result<double> read(PlyType type);
  /// Passes over values of a type; false at the end of the data.
  bool skip(PlyType type, std::uint64_t count);
  /// The bytes that are left, and the fewest that a value takes: a digit and a space, which the last lacks.
  std::uint64_t remaining() const { return std::uint64_t{cursor_.remaining()} + 1; }
  static std::uint64_t least_size(PlyType) { return 2; }
  /// Where the last value is: "line 12".
  std::string place() const;

 private:
  TextCursor cursor_;
  std::size_t header_lines_;
};

/// Values of a binary PLY file.
class PlyBinaryValues {
 public:
  PlyBinaryValues(std::span<const std::byte> file, const PlyHeader& header);

  Result<double> read(PlyType type);
  bool skip(PlyType type, std::uint64_t count);
  std::uint64_t remaining() const { return file_.size() - at_; }
  static std::uint64_t least_size(PlyType type) { return size_of(type); }
  std::string place() const;  // "byte 345", from 0

 private:
  std::span<const std::byte> file_;
  std::size_t at_;
  std::size_t last_ = 0;  // begin of the last value
  bool big_endian_;
};

}  // namespace weft::mesh
