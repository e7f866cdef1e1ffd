#pragma once

#include <cstdint>

namespace weft {

/// Mirror of src/method/multigrid/cloth_nodes.wgsl: the nodes of one cloth among the vertices.
struct ClothNodes {
  std::uint32_t first_vertex = 0, count = 0;
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(ClothNodes) == 16);

}  // namespace weft
