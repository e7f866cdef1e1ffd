#include "method/multigrid/reference/cycle.hpp"

namespace weft::reference {

Hierarchy::Hierarchy(GridOperator fine, const GridOperator& source, const Bottom& bottom,
                     const Smoothing& finest)
    : Cycle(bottom, finest) {
  const std::vector<GridLevel> shapes = grid_levels(fine.nx, fine.ny);
  const GridBending bending = fine.bending;
  add(std::move(fine));
  for (std::size_t l = 1; l < shapes.size() && l <= bottom.level; ++l)
    add(coarsened(l == 1 ? source : levels().back(), shapes[l], bending));
}

MeshHierarchy::MeshHierarchy(MeshOperator fine, const Bottom& bottom, const Smoothing& finest)
    : Cycle(bottom, finest) {
  add(std::move(fine));
  while (levels().back().coarser() && levels().size() <= bottom.level) add(coarsened(levels().back()));
}

}  // namespace weft::reference
