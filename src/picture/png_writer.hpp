#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "base/result.hpp"
#include "picture/image.hpp"

namespace weft::picture {

/// Writes PNG files on a thread of its own, so that the next picture is drawn meanwhile.
class PngWriter {
 public:
  explicit PngWriter(std::size_t capacity = 4);
  ~PngWriter();  ///< writes what waits
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  /// Hands a picture over; waits while `capacity` pictures are waiting.
  /// Errors  the first that any write has met; nothing is written after it.
  Result<void> push(std::string path, Image image);
  /// Waits until all is written.
  Result<void> finish();

 private:
  struct Job {
    std::string path;
    Image image;
  };
  void work();

  std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool busy_ = false, stop_ = false;
  Result<void> first_error_;
  std::thread thread_;
};

}  // namespace weft::picture
