#include "gpu/native/wgpu_version.hpp"

#include <wgpu.h>

namespace weft::gpu {

std::string wgpu_version() {
  const std::uint32_t version = wgpuGetVersion();  // four numbers of a byte
  std::string text;
  for (const int shift : {24, 16, 8, 0})
    text += (text.empty() ? "" : ".") + std::to_string((version >> static_cast<unsigned>(shift)) & 0xffU);
  return text;
}

}  // namespace weft::gpu
