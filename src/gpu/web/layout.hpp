// Where a browser's build has the parts of commands, in bytes. An Id has 4 bytes there, so a native build
// cannot tell: imports.hpp holds the browser's compiler to these numbers, and tests/layouts hands them to the
// tests of gpu_backend.ts.
#pragma once

#include <cstdint>

namespace weft::gpu::backend::web {

struct CommandLayout {
  std::uint32_t size = 64, ids = 4, args = 16, sizes = 40;
};
struct RenderTargetLayout {
  std::uint32_t size = 56, color = 0, resolve = 4, depth = 8, clear_color = 16, store_depth = 48;
};
inline constexpr CommandLayout kCommandLayout;
inline constexpr RenderTargetLayout kRenderTargetLayout;

}  // namespace weft::gpu::backend::web
