#pragma once

#include <string>

namespace weft::cli {

/// "weft 0.1.0 (commit 0123456789ab, wgpu-native 29.0.0.0)"
std::string version_text();

}  // namespace weft::cli
