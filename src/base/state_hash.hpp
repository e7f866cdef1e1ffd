#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace weft {

/// XXH3-64 of the bits of position, then velocity, as 16 hexadecimal digits.
std::string state_hash(std::span<const std::byte> position, std::span<const std::byte> velocity);

}  // namespace weft
