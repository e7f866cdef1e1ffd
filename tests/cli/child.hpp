// A program that a test runs: what it says, how it ends, what it costs.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace weft {

struct Ended {
  int code = 0;          // exit code; the negative number of the signal that ended it; kTimedOut
  std::string out, err;  // standard output and error
  double cpu_s = 0;      // user and system
  std::size_t peak = 0;  // resident [bytes]
};

constexpr int kTimedOut = -1000;  // it was killed at the limit

struct CallOptions {
  std::vector<std::string> environment;  // NAME=VALUE over this process's own; NAME alone takes it away
  std::string folder;                    // where it runs; empty: here
  bool terminal = false;                 // standard error is a terminal
};

/// A running program. It lacks root's right to read and write what permissions forbid, so that a file without
/// permissions is one for every user who runs the tests.
class Child {
 public:
  Child(const std::vector<std::string>& arguments, const CallOptions& options);
  ~Child();  ///< kills it, if it was not waited for
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void signal(int number) const;
  /// Reads what it says until it ends, or until this long after its start [s]; then it is killed.
  Ended wait(double limit = 200);

 private:
  bool read_some(double seconds);

  pid_t id_ = -1;
  int files_[2] = {-1, -1};  // our ends of its output and error
  std::string said_[2];
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

inline Ended call(const std::vector<std::string>& arguments, const CallOptions& options = {}) {
  return Child(arguments, options).wait();
}

}  // namespace weft
