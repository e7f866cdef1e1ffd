#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

namespace weft {

/// A folder of its own for one test, removed with all in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    char name[] = "/tmp/weft-test-XXXXXX";
    path_ = mkdtemp(name);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return name.empty() ? path_ : path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace weft
