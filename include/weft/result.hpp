// Errors are values: no function of weft throws.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace weft {

/// Why something failed.
enum class ErrorKind {
  Failure,      ///< anything without a better name
  Usage,        ///< the command line is wrong
  Input,        ///< a file or a value in it is missing or wrong
  Shape,        ///< two sizes that must agree do not
  Shader,       ///< a kernel does not compile, or a GPU call is invalid
  NoAdapter,    ///< no WebGPU adapter, or none of that name
  Limit,        ///< larger than the adapter, or weft, allows
  OutOfMemory,  ///< the GPU has no memory left
  DeviceLost,   ///< the GPU device is gone
  Diverged,     ///< the state is no longer finite
  Interrupted,  ///< the user stopped the run
};

struct Error {
  ErrorKind kind = ErrorKind::Failure;
  std::string message;  // a sentence in the present tense that gives the value and the limit

  /// Adds what was being done: "While reading scene a.json: ...".
  Error while_doing(const std::string& what) const { return {kind, "While " + what + ": " + message}; }
};

/// A value, or the reason why there is none. `value()` and `error()` may be asked only for what is there.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return content_.index() == 0; }
  T& value() & { return *std::get_if<0>(&content_); }
  const T& value() const& { return *std::get_if<0>(&content_); }
  T&& value() && { return std::move(*std::get_if<0>(&content_)); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return *std::get_if<1>(&content_); }

 private:
  std::variant<T, Error> content_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  explicit operator bool() const { return ok_; }
  const Error& error() const { return error_; }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace weft
