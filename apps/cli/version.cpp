#include "version.hpp"

#include "gpu/native/wgpu_version.hpp"
#include "weft_commit.hpp"

namespace weft::cli {

std::string version_text() {
  return std::string(WEFT_VERSION) + " (commit " + WEFT_COMMIT + ", wgpu-native " + gpu::wgpu_version() + ")";
}

}  // namespace weft::cli
