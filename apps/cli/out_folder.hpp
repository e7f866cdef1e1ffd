#pragma once

#include <string>
#include <utility>

#include "base/result.hpp"

namespace weft::cli {

/// The folder of a run's results, which no other run may write into meanwhile.
class OutFolder {
 public:
  /// Makes the folder, and removes what an earlier run left there: its results, and temporary files that it
  /// was killed over. Errors  Failure: the folder cannot be made or written; another run has it.
  static Result<OutFolder> take(const std::string& path);

  OutFolder(OutFolder&& other) noexcept
      : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}
  OutFolder& operator=(OutFolder&&) = delete;
  ~OutFolder();  ///< gives it back

  const std::string& path() const { return path_; }

 private:
  OutFolder(std::string path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::string path_;
  int lock_ = -1;  // file descriptor
};

}  // namespace weft::cli
