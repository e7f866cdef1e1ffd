#pragma once

#include <array>
#include <span>
#include <vector>

#include "method/multigrid/mesh_levels.hpp"

namespace weft {

/// Mirror of src/method/multigrid/mesh_level.wgsl: the place of a mesh's level in the buffers of all its levels.
struct MeshLevelParams {
  std::uint32_t node_count = 0, block_count = 0;  // 0: there is no such level
  std::uint32_t first_vector = 0;                 // [vec4f]
  std::uint32_t first_row = 0, first_source = 0, first_product = 0, first_taps = 0, padding = 0;
};
static_assert(sizeof(MeshLevelParams) == 32);

inline std::uint32_t node_count(const MeshLevelParams& level) { return level.node_count; }

namespace multigrid {

/// Nodes of a coarser level that a node takes from: src/method/multigrid/mesh_level.wgsl.
inline std::uint32_t taps_of(bool volume) { return volume ? 4 : 3; }
/// The invocations that take the entries of a row in turns: the same file.
inline constexpr std::uint32_t kLanes = 4;

}  // namespace multigrid

/// The entries in which a block stands: of two nodes that are coupled two, of a node itself one, twice.
using BlockEntries = std::array<std::uint32_t, 2>;

/// The levels of a mesh as kernels read them: the lists of all levels one after the other. A row begins with the entry
/// of its own node.
struct MeshLists {
  std::vector<MeshLevelParams> levels;  // the finest first
  std::size_t vector_count = 0;         // [vec4f]
  std::vector<std::uint32_t> row_starts, source_starts, product_starts;
  std::vector<std::uint32_t> entries;  // the node of each
  std::vector<Share> sources, products, taps;
  std::vector<std::vector<BlockEntries>> entries_of;  // of each level's blocks
};
/// `air`: whether it pushes, and the finest level has its vectors. `volume`: whether the mesh is of tetrahedra.
MeshLists mesh_lists(std::span<const MeshLevel> levels, bool air = false, bool volume = false);

}  // namespace weft
