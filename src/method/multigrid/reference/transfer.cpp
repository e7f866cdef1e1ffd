#include "method/multigrid/reference/transfer.hpp"

namespace weft::reference {
namespace {

/// Calls visit(coarse node, weight) for all that a fine node's value comes from.
template <class Visit>
void for_each_tap(const GridOperator& fine, std::uint32_t node, const Visit& visit) {
  if (fine.fixed[node]) return;
  const Taps ti = taps(node % fine.nx, fine.nx), tj = taps(node / fine.nx, fine.ny);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double weight = ti.weight[i] * tj.weight[j];
      if (weight > 0) visit(tj.node[j] * coarser_side(fine.nx) + ti.node[i], weight);
    }
}

double ratio(std::uint32_t interval, std::uint32_t last) { return static_cast<double>(interval) / last; }

}  // namespace

Taps taps(std::uint32_t i, std::uint32_t n) {
  if (coarser_side(n) == n) return {{i, i}, {1, 0}};
  if (i + 1 == n) return {{n / 2, n / 2}, {1, 0}};
  if (i % 2 == 0) return {{i / 2, i / 2}, {1, 0}};
  return {{i / 2, i / 2 + 1}, {0.5, 0.5}};
}

Field prolonged(const Field& coarse, const GridOperator& fine) {
  Field result(fine.size());
  for (std::uint32_t a = 0; a < fine.size(); ++a)
    for_each_tap(fine, a, [&](std::uint32_t node, double weight) { result[a] += weight * coarse[node]; });
  return result;
}

Field restricted(const Field& residual, const GridOperator& fine) {
  Field result(std::size_t{coarser_side(fine.nx)} * coarser_side(fine.ny));
  for (std::uint32_t a = 0; a < fine.size(); ++a)
    for_each_tap(fine, a, [&](std::uint32_t node, double weight) { result[node] += weight * residual[a]; });
  return result;
}

GridOperator coarsened(const GridOperator& fine, const GridLevel& level, const GridBending& bending) {
  GridOperator coarse;
  coarse.nx = level.nx;
  coarse.ny = level.ny;
  coarse.rows.resize(std::size_t{level.nx} * level.ny);
  coarse.fixed.assign(coarse.rows.size(), false);
  coarse.bending = {bending.along_i * level.bending_i, bending.along_j * level.bending_j,
                    ratio(level.interval_i, level.last_i), ratio(level.interval_j, level.last_j),
                    bending.uniform};
  // Adds `block` at row K, column L. Of the two blocks of a pair one is stored, and of the two halves of a
  // pair that becomes one coarse node both count.
  const auto add = [&](std::uint32_t k, std::uint32_t l, const Sym3& block) {
    if (l < k) return;
    const std::uint32_t down = l / coarse.nx - k / coarse.nx;       // 0 or 1
    const std::uint32_t right = l % coarse.nx + 1 - k % coarse.nx;  // 0, 1 or 2
    const std::size_t place = down == 0 ? right - 1 : right == 0 ? 4 : 1 + right;
    coarse.rows[k][place] += block;
  };
  const auto product = [&](std::uint32_t a, std::uint32_t b, const Sym3& block) {
    for_each_tap(fine, a, [&](std::uint32_t k, double wk) {
      for_each_tap(fine, b, [&](std::uint32_t l, double wl) { add(k, l, (wk * wl) * block); });
    });
  };
  for (std::uint32_t j = 0; j < fine.ny; ++j)
    for (std::uint32_t i = 0; i < fine.nx; ++i) {
      const std::uint32_t a = j * fine.nx + i;
      const StencilRow& row = fine.rows[a];
      const auto both = [&](std::uint32_t b, const Sym3& block) {
        product(a, b, block);
        product(b, a, block);
      };
      product(a, a, row[0]);
      if (i + 1 < fine.nx) both(a + 1, row[1]);
      if (j + 1 < fine.ny) both(a + fine.nx, row[2]);
      if (i + 1 < fine.nx && j + 1 < fine.ny) both(a + fine.nx + 1, row[3]);
      if (i > 0 && j + 1 < fine.ny) both(a + fine.nx - 1, row[4]);
    }
  return coarse;
}

}  // namespace weft::reference
