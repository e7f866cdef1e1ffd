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
      coarse.even_i = fine.even_i && fine.nx % 2 == 1;
      coarse.bending_i /= 4;
      coarse.bending_j *= 2;
    }
    if (halves_j) {
      coarse.even_j = fine.even_j && fine.ny % 2 == 1;
      coarse.bending_j /= 4;
      coarse.bending_i *= 2;
    }
    levels.push_back(coarse);
  }
}

}  // namespace weft
