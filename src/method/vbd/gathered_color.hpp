#pragma once

#include <cstdint>

namespace weft {

/// The nodes of a colour of a body whose nodes gather their elements. Mirror: src/method/vbd/gathered_color.wgsl.
struct GatheredColor {
  std::uint32_t first = 0, count = 0;
  std::uint32_t first_node = 0, rows = 0;
};
static_assert(sizeof(GatheredColor) == 16);

}  // namespace weft
