// The levels of the multigrid solver for a cloth that is a mesh: one rule for the kernels and for the
// reference. Source: docs/solvers/multigrid.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/coarse_mesh.hpp"
#include "model/model.hpp"

namespace weft {

/// Lists one after the other.
template <class Item>
struct Lists {
  std::vector<std::uint32_t> starts = {0};  // one more than there are lists
  std::vector<Item> items;

  std::size_t size() const { return starts.size() - 1; }
  std::span<const Item> of(std::size_t list) const {
    return std::span(items).subspan(starts[list], starts[list + 1] - starts[list]);
  }
  /// Ends the list to which items were added.
  void close() { starts.push_back(static_cast<std::uint32_t>(items.size())); }
};

/// An off-diagonal entry of a matrix row.
struct Coupling {
  std::uint32_t node = 0, block = 0;
};
using mesh::Share;

/// A level. Its matrix is symmetric and made of symmetric blocks: first those of the diagonal, node by node,
/// then one for each two nodes that are coupled.
struct MeshLevel {
  std::uint32_t node_count = 0, block_count = 0;
  Lists<Coupling> rows;  // of each node
  // From the next finer level; empty for the finest.
  std::vector<std::array<Share, 3>> taps;  // P: of each finer node, this level's nodes
  Lists<Share> sources;                    // Pᵀ: of each node, the finer nodes that take from it
  Lists<Share> products;                   // Pᵀ A P: of each block, the finer blocks whose sum it is
};

/// No level of fewer nodes than this is made coarser.
inline constexpr std::uint32_t kLeastNodes = 25;

/// The levels of a cloth, the finest first. Of that, block node_count + s is that of springs[s], which join
/// nodes of the cloth and no two of them twice.
std::vector<MeshLevel> mesh_levels(const Model& model, const Body& body, const Springs& springs);

}  // namespace weft
