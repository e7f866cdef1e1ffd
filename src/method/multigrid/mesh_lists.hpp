#pragma once

#include "method/multigrid/mesh_levels.hpp"

namespace weft {

/// Mirror of src/method/multigrid/mesh_level.wgsl: the place of a mesh's level in the buffers of all its levels.
struct MeshLevelParams {
  std::uint32_t node_count = 0, block_count = 0;  // 0: there is no such level
  std::uint32_t first_vector = 0;                 // [vec4f]
  std::uint32_t first_block = 0;                  // [two vec4f]
  std::uint32_t first_row = 0, first_source = 0, first_product = 0, first_taps = 0;
};
static_assert(sizeof(MeshLevelParams) == 32);

inline std::uint32_t node_count(const MeshLevelParams& level) { return level.node_count; }

namespace multigrid {

/// Nodes of a finer level that a node takes from: src/method/multigrid/mesh_level.wgsl.
inline constexpr std::uint32_t kTaps = 3;

}  // namespace multigrid

/// The levels of a mesh as kernels read them: the lists of all levels one after the other.
struct MeshLists {
  std::vector<MeshLevelParams> levels;  // the finest first
  std::size_t vector_count = 0;         // [vec4f]
  std::size_t block_count = 0;          // of all levels
  std::vector<std::uint32_t> row_starts, source_starts, product_starts;
  std::vector<Coupling> rows;
  std::vector<Share> sources, products, taps;
};
MeshLists mesh_lists(const std::vector<MeshLevel>& levels);

}  // namespace weft
