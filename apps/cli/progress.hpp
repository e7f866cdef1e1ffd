#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace weft::cli {

/// A bar on stderr with what is done and the time that is left; only on a terminal.
class Progress {
 public:
  explicit Progress(std::string what, std::uint32_t total);
  ~Progress();  ///< clears the line
  void show(std::uint32_t done, double milliseconds_per_item);

 private:
  std::string what_;
  std::uint32_t total_;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace weft::cli
