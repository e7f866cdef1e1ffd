#include "method/multigrid/grid_levels.hpp"

namespace weft {

std::vector<GridLevel> grid_levels(std::uint32_t nx, std::uint32_t ny) {
  std::vector<GridLevel> levels = {{nx, ny}};
  for (;;) {
    const GridLevel& fine = levels.back();
    GridLevel coarse = fine;
    coarse.nx = coarser_side(fine.nx);
    coarse.ny = coarser_side(fine.ny);
    const bool halves_i = coarse.nx != fine.nx, halves_j = coarse.ny != fine.ny;
    if (!halves_i && !halves_j) return levels;
    if (halves_i) {
      coarse.interval_i = 2 * fine.interval_i;
      coarse.last_i = fine.last_i + (fine.nx % 2 == 1 ? fine.interval_i : 0);
      coarse.bending_i /= 4;
      coarse.bending_j *= 2;
    }
    if (halves_j) {
      coarse.interval_j = 2 * fine.interval_j;
      coarse.last_j = fine.last_j + (fine.ny % 2 == 1 ? fine.interval_j : 0);
      coarse.bending_j /= 4;
      coarse.bending_i *= 2;
    }
    levels.push_back(coarse);
  }
}

}  // namespace weft
