#include "method/multigrid/reference/cycle.hpp"

namespace weft::reference {
namespace {

BottomSweeps sweeps_of(const std::optional<Bottom>& bottom) {
  return bottom ? bottom->sweeps : BottomSweeps{};
}

}  // namespace

Hierarchy::Hierarchy(GridOperator fine, const GridOperator& source, const std::optional<Bottom>& bottom)
    : Cycle(sweeps_of(bottom)) {
  const std::vector<GridLevel> shapes = grid_levels(fine.nx, fine.ny);
  const std::size_t last = bottom ? bottom->level : shapes.size() - 1;
  const GridBending bending = fine.bending;
  add(std::move(fine));
  for (std::size_t l = 1; l <= last; ++l)
    add(coarsened(l == 1 ? source : levels().back(), shapes[l], bending));
}

MeshHierarchy::MeshHierarchy(MeshOperator fine, const std::optional<Bottom>& bottom)
    : Cycle(sweeps_of(bottom)) {
  const std::size_t last = bottom ? bottom->level : fine.levels.size() - 1;
  add(std::move(fine));
  while (levels().size() <= last) add(coarsened(levels().back()));
}

}  // namespace weft::reference
