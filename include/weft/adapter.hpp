#pragma once

#include <string>

namespace weft {

/// What a GPU calls itself.
struct AdapterInfo {
  std::string name;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string vendor;
  std::string driver;   // the driver's own description
  std::string backend;  // "Vulkan"
  std::string type;     // "discrete GPU", "integrated GPU", "CPU"
};

}  // namespace weft
