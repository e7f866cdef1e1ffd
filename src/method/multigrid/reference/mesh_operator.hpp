// The matrix of one level of the multigrid solver, for a cloth that is a mesh. Source:
// docs/solvers/multigrid.md.
#pragma once

#include "method/multigrid/mesh_levels.hpp"
#include "method/multigrid/reference/grid_operator.hpp"

namespace weft::reference {

/// A symmetric matrix of 3 x 3 blocks on a level of a mesh: MeshLevel numbers them. All blocks of a fixed node are 0.
struct MeshOperator {
  std::span<const MeshLevel> levels;  // its own, and all coarser ones
  std::vector<Sym3> blocks;           // their symmetric parts [N/m]
  std::vector<Vec3d> skews;           // s of the rest, v -> s x v, of each [N/m]; none: blocks are symmetric
  double diagonal_part = 1;           // that counts as inverse of the diagonal, where smoothing needs less

  std::size_t size() const { return levels[0].node_count; }
  const MeshLevel* coarser() const { return levels.size() > 1 ? &levels[1] : nullptr; }
  bool fixed(std::size_t node) const { return blocks[node].trace() == 0; }
  /// A x.
  Field apply(const Field& x) const;
  Vec3d times(const BlockPlace& at, const Vec3d& x) const;
  /// As GridOperator's.
  /// The diagonal's blocks, 0 where nodes are fixed.
  std::span<const Sym3> diagonal() const { return std::span(blocks).first(size()); }
  std::vector<Sym3> inverse_diagonal() const;
};

/// P e: 0 where fine nodes are fixed.
Field prolonged(const Field& coarse, const MeshOperator& fine);
/// Pᵀ r.
Field restricted(const Field& residual, const MeshOperator& fine);
/// Pᵀ A P.
MeshOperator coarsened(const MeshOperator& fine);

}  // namespace weft::reference
