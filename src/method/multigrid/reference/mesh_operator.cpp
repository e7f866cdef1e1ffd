#include "method/multigrid/reference/mesh_operator.hpp"

namespace weft::reference {

Vec3d MeshOperator::times(const BlockPlace& at, const Vec3d& x) const {
  const Vec3d product = blocks[at.block] * x;
  if (skews.empty()) return product;
  return product + (at.transposed ? -1.0 : 1.0) * cross(skews[at.block], x);
}

Field MeshOperator::apply(const Field& x) const {
  Field y(size());
  for (std::size_t a = 0; a < size(); ++a) {
    y[a] = blocks[a] * x[a];
    for (const Coupling& coupling : levels[0].rows.of(a)) y[a] += times(coupling.at, x[coupling.node]);
  }
  return y;
}

std::vector<Sym3> MeshOperator::inverse_diagonal() const {
  std::vector<Sym3> inverses(size());
  for (std::size_t a = 0; a < size(); ++a)
    if (!fixed(a))
      inverses[a] = diagonal_part * inverse(blocks[a] + Sym3::identity(kDiagonalMargin * blocks[a].trace()));
  return inverses;
}

Field prolonged(const Field& coarse, const MeshOperator& fine) {
  Field result(fine.size());
  for (std::size_t a = 0; a < fine.size(); ++a) {
    if (fine.fixed(a)) continue;
    for (const Share& tap : fine.coarser()->taps[a])
      result[a] += static_cast<double>(tap.weight) * coarse[tap.index];
  }
  return result;
}

Field restricted(const Field& residual, const MeshOperator& fine) {
  const MeshLevel& coarse = *fine.coarser();
  Field result(coarse.node_count);
  for (std::size_t node = 0; node < result.size(); ++node)
    for (const Share& source : coarse.sources.of(node))
      if (!fine.fixed(source.index))
        result[node] += static_cast<double>(source.weight) * residual[source.index];
  return result;
}

MeshOperator coarsened(const MeshOperator& fine) {
  const MeshLevel& level = *fine.coarser();
  MeshOperator coarse{fine.levels.subspan(1), std::vector<Sym3>(level.block_count), {}, fine.diagonal_part};
  coarse.skews.resize(fine.skews.empty() ? 0 : level.block_count);
  for (std::size_t block = 0; block < coarse.blocks.size(); ++block)
    for (const auto& [at, part] : level.products.of(block)) {
      const auto weight = static_cast<double>(part);
      coarse.blocks[block] += weight * fine.blocks[at.block];
      if (fine.skews.empty() || block < level.node_count) continue;  // on the diagonal they cancel
      coarse.skews[block] += (at.transposed ? -weight : weight) * fine.skews[at.block];
    }
  return coarse;
}

}  // namespace weft::reference
