#include "base/result.hpp"

#include <cstdarg>
#include <cstdio>

namespace weft {
namespace {

std::string format_message(const char* format, std::va_list arguments) {
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  std::string message(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  if (length > 0) std::vsnprintf(message.data(), message.size() + 1, format, again);
  va_end(again);
  return message;
}

}  // namespace

Error make_error(ErrorKind kind, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  Error error{kind, format_message(format, arguments)};
  va_end(arguments);
  return error;
}

Error input_error(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  Error error{ErrorKind::Input, format_message(format, arguments)};
  va_end(arguments);
  return error;
}

Error shape_error(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  Error error{ErrorKind::Shape, format_message(format, arguments)};
  va_end(arguments);
  return error;
}

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Usage:
      return 2;
    case ErrorKind::Input:
      return 3;
    case ErrorKind::NoAdapter:
    case ErrorKind::Limit:
    case ErrorKind::OutOfMemory:
      return 4;
    case ErrorKind::DeviceLost:
      return 5;
    case ErrorKind::Diverged:
      return 6;
    case ErrorKind::Interrupted:
      return 130;
    case ErrorKind::Failure:
    case ErrorKind::Shape:
    case ErrorKind::Shader:
      break;
  }
  return 1;
}

}  // namespace weft
