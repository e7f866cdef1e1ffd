#pragma once

#include <cstdint>

#include "base/result.hpp"

namespace weft::cli {

/// Bytes that a new program may use without others being swapped out, as Linux estimates it.
/// Errors  Failure: this system does not say.
Result<std::uint64_t> available_memory();

}  // namespace weft::cli
