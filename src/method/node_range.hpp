#pragma once

#include <cstdint>

namespace weft {

/// What FabricParams and SolidParams begin with. Mirror: src/method/mass_spring/advance_gathered.wgsl.
struct NodeRange {
  std::uint32_t first = 0, count = 0;
};
static_assert(sizeof(NodeRange) == 8);

}  // namespace weft
