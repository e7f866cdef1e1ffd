#pragma once

#include <string>

namespace weft::gpu {

/// The version of the wgpu-native library that runs: "29.0.0.0".
std::string wgpu_version();

}  // namespace weft::gpu
