#include "method/multigrid/reference/mesh_operator.hpp"

namespace weft::reference {

Field MeshOperator::apply(const Field& x) const {
  Field y(size());
  for (std::size_t a = 0; a < size(); ++a) {
    y[a] = blocks[a] * x[a];
    for (const Coupling& coupling : levels[0].rows.of(a)) y[a] += blocks[coupling.block] * x[coupling.node];
  }
  return y;
}

std::vector<Sym3> MeshOperator::inverse_diagonal() const {
  std::vector<Sym3> inverses(size());
  for (std::size_t a = 0; a < size(); ++a)
    if (!fixed(a)) inverses[a] = inverse(blocks[a] + Sym3::identity(kDiagonalMargin * blocks[a].trace()));
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
  MeshOperator coarse{fine.levels.subspan(1), std::vector<Sym3>(level.block_count)};
  for (std::size_t block = 0; block < coarse.blocks.size(); ++block)
    for (const Share& product : level.products.of(block))
      coarse.blocks[block] += static_cast<double>(product.weight) * fine.blocks[product.index];
  return coarse;
}

}  // namespace weft::reference
