// How the module's functions answer: a number, and a sentence or text beside it.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.hpp"

namespace weft::web {

/// The result of weft_message: the sentence of the last error, or the text that was asked for.
inline std::string message;

/// 0, or 1 + the ErrorKind with its sentence in `message`.
inline std::uint32_t code(const Result<void>& result) {
  if (result) return 0;
  message = result.error().message;
  return 1 + static_cast<std::uint32_t>(result.error().kind);
}

inline std::string text(const char* data, std::uint32_t size) { return {data, size}; }

}  // namespace weft::web
