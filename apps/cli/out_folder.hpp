#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "base/result.hpp"

namespace weft::cli {

/// The folder of a run's results, which no other run may write into meanwhile.
class OutFolder {
 public:
  /// Makes the folder, and removes what an earlier run left there: its results, and temporary files that it
  /// was killed over. Files of frames before `first` stay, and so does the file `kept`: a run that is resumed goes on
  /// from them. Errors  Failure: the folder cannot be made or written; another run has it.
  static Result<OutFolder> take(const std::string& path, std::uint32_t first, const std::string& kept);

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
