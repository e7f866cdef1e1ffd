// What can fail for the user returns a Result; what only a programmer can get wrong is an assert.
#pragma once

#include <cassert>

#include "weft/result.hpp"

namespace weft {

/// An error whose message is formatted as by printf.
[[gnu::format(printf, 2, 3)]] Error make_error(ErrorKind kind, const char* format, ...);
[[gnu::format(printf, 1, 2)]] Error input_error(const char* format, ...);
[[gnu::format(printf, 1, 2)]] Error shape_error(const char* format, ...);

/// The process exit code that stands for this kind (docs/cli.md).
int exit_code(ErrorKind kind);

}  // namespace weft

#define WEFT_CONCAT_INNER(a, b) a##b
#define WEFT_CONCAT(a, b) WEFT_CONCAT_INNER(a, b)

/// Declares `name` as the value of `expression`, or returns its error.
#define WEFT_TRY(name, expression)                                     \
  auto WEFT_CONCAT(weft_result_, __LINE__) = (expression);             \
  if (!WEFT_CONCAT(weft_result_, __LINE__))                            \
    return ::weft::Error(WEFT_CONCAT(weft_result_, __LINE__).error()); \
  auto name = std::move(WEFT_CONCAT(weft_result_, __LINE__)).value()

/// Assigns the value of `expression` to `target`, or returns its error.
#define WEFT_SET(target, expression)                         \
  do {                                                       \
    auto weft_set_ = (expression);                           \
    if (!weft_set_) return ::weft::Error(weft_set_.error()); \
    target = std::move(weft_set_).value();                   \
  } while (false)

/// Returns the error of `expression`, a Result<void>, if it has one.
#define WEFT_CHECK(expression)                                                                    \
  do {                                                                                            \
    if (auto weft_check_ = (expression); !weft_check_) return ::weft::Error(weft_check_.error()); \
  } while (false)
