#include "mesh/ply_values.hpp"

#include <cmath>
#include <cstring>

#include "mesh/number.hpp"

namespace weft::mesh {
namespace {

template <class T>
double from_bits(std::uint64_t bits) {
  T value;
  if constexpr (sizeof(T) == 8) {
    std::memcpy(&value, &bits, sizeof value);
  } else {
    const auto low = static_cast<std::uint32_t>(bits);
    std::memcpy(&value, &low, sizeof value);
  }
  return static_cast<double>(value);
}

double decode(PlyType type, std::uint64_t bits) {
  switch (type) {
    case PlyType::Int8:
      return static_cast<double>(static_cast<std::int8_t>(bits));
    case PlyType::Int16:
      return static_cast<double>(static_cast<std::int16_t>(bits));
    case PlyType::Int32:
      return static_cast<double>(static_cast<std::int32_t>(bits));
    case PlyType::Uint8:
    case PlyType::Uint16:
    case PlyType::Uint32:
      return static_cast<double>(bits);
    case PlyType::Float32:
      return from_bits<float>(bits);
    case PlyType::Float64:
      break;
  }
  return from_bits<double>(bits);
}

}  // namespace

PlyTextValues::PlyTextValues(std::span<const std::byte> file, const PlyHeader& header)
    : cursor_(file.subspan(header.size), {}), header_lines_(header.line_count) {}

Result<double> PlyTextValues::read(PlyType type) {
  const std::string_view word = cursor_.next();
  if (word.empty()) return input_error("The file ends on %s, before its data are complete.", place().c_str());
  if (is_integer(type)) {
    // Exact: what does not fit into 32 bits is refused by whoever asked for a count or an index.
    if (const auto value = parse_integer(word)) return static_cast<double>(*value);
  } else if (type == PlyType::Float32) {
    if (const auto value = parse_float(word)) return static_cast<double>(*value);
  } else if (const auto value = parse_double(word)) {
    return *value;
  }
  return input_error("The value \"%s\" on %s is not a finite %s.", quoted(word).c_str(), place().c_str(),
                     is_integer(type) ? "integer" : "number");
}

bool PlyTextValues::skip(PlyType, std::uint64_t count) {
  for (; count > 0; --count)
    if (cursor_.next().empty()) return false;
  return true;
}

std::string PlyTextValues::place() const { return "line " + std::to_string(header_lines_ + cursor_.line()); }

PlyBinaryValues::PlyBinaryValues(std::span<const std::byte> file, const PlyHeader& header)
    : file_(file), at_(header.size), big_endian_(header.format == PlyFormat::BinaryBig) {}

Result<double> PlyBinaryValues::read(PlyType type) {
  const std::size_t size = size_of(type);
  if (file_.size() - at_ < size)
    return input_error("The file ends at byte %zu, before its data are complete.", file_.size());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t shift = 8 * (big_endian_ ? size - 1 - i : i);
    bits |= std::to_integer<std::uint64_t>(file_[at_ + i]) << shift;
  }
  last_ = at_;
  at_ += size;
  return decode(type, bits);
}

bool PlyBinaryValues::skip(PlyType type, std::uint64_t count) {
  if (count > remaining() / size_of(type)) return false;
  at_ += static_cast<std::size_t>(count) * size_of(type);
  return true;
}

std::string PlyBinaryValues::place() const { return "byte " + std::to_string(last_); }

}  // namespace weft::mesh
