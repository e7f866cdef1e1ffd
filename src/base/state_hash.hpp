#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace weft {

/// XXH3-64 of the bits of position, then velocity, as 16 hexadecimal digits.
std::string state_hash(std::span<const std::byte> position, std::span<const std::byte> velocity);

/// XXH3-64 of bytes.
std::uint64_t bytes_hash(std::span<const std::byte> bytes);

/// A hash as 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace weft
