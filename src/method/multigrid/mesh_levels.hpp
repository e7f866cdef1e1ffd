// The levels of the multigrid solver for a cloth that is a mesh: one rule for the kernels and for the
// reference. Source: docs/solvers/multigrid.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/lists.hpp"
#include "mesh/coarse_mesh.hpp"
#include "method/multigrid/systems.hpp"
#include "model/model.hpp"

namespace weft {

/// A block of a level's matrix, or its transpose.
struct BlockPlace {
  std::uint32_t block = 0;
  bool transposed = false;

  bool operator==(const BlockPlace&) const = default;
};
/// An off-diagonal entry of a matrix row.
struct Coupling {
  std::uint32_t node = 0;
  BlockPlace at;
};
/// A part of a sum of blocks.
struct BlockShare {
  BlockPlace at;
  float weight = 0;
};
using mesh::Share;

/// A level. Its matrix is symmetric and made of blocks: first those of the diagonal, node by node, which are symmetric,
/// then one for each two nodes that are coupled: the row of one, the column of the other.
struct MeshLevel {
  std::uint32_t node_count = 0, block_count = 0;
  Lists<Coupling> rows;  // of each node
  // From the next finer level; empty for the finest.
  std::vector<mesh::Taps> taps;  // P: of each finer node, this level's nodes
  Lists<Share> sources;          // Pᵀ: of each node, the finer nodes that take from it
  Lists<BlockShare> products;    // Pᵀ A P: of each block, the finer blocks whose sum it is
};

/// No level of fewer nodes than this is made coarser.
inline constexpr std::uint32_t kLeastNodes = 25;

/// Whether blocks of two nodes are symmetric, as those of springs are: then none is taken transposed.
enum class Blocks { Symmetric, General };

/// The levels of a cloth or of bodies, the finest first. Of that, block node_count + p is that of pairs[p], two nodes,
/// whose numbers count from 0; no two pairs are the same.
std::vector<MeshLevel> mesh_levels(const Model& model, const multigrid::SystemBodies& bodies,
                                   std::span<const mesh::Edge> pairs, Blocks blocks);
/// Those of a cloth of springs: a pair is a spring.
std::vector<MeshLevel> mesh_levels(const Model& model, const Body& body, const Springs& springs);

}  // namespace weft
