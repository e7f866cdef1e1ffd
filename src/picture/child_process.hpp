// Another program, fed through its standard input.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace weft::picture {

/// The file that a program's name stands for on PATH.
std::optional<std::string> find_program(const std::string& name);

/// A running program. Its standard output is dropped; the end of what it says on standard error becomes the
/// error.
class ChildProcess {
 public:
  ChildProcess() = default;
  ChildProcess(ChildProcess&& other) noexcept { swap(other); }
  ChildProcess& operator=(ChildProcess&& other) noexcept {
    swap(other);
    return *this;
  }
  ~ChildProcess();  ///< kills it, if it was not waited for

  /// Starts `arguments[0]`, a file, in a process group of its own, so that Ctrl-C leaves its end to us.
  /// Errors  Failure: it cannot be started.
  static Result<ChildProcess> start(const std::vector<std::string>& arguments);

  /// Writes all bytes; blocks while the program is busy.
  /// Errors  Failure: it has ended, with what it said.
  Result<void> write(std::span<const std::byte> bytes);
  /// Closes its input and waits for its end.
  /// Errors  Failure: its exit code is not 0, with what it said.
  Result<void> finish();

 private:
  void swap(ChildProcess& other) {
    std::swap(name_, other.name_);
    std::swap(id_, other.id_);
    std::swap(input_, other.input_);
    std::swap(said_, other.said_);
  }
  void close_input();
  std::string last_words();

  std::string name_;
  pid_t id_ = -1;
  int input_ = -1;  // file descriptors
  int said_ = -1;
};

}  // namespace weft::picture
