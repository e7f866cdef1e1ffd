#include "method/equal_cloths.hpp"

#include <algorithm>

#include "element/spring/spring_grid.hpp"

namespace weft {
namespace {

bool equal(const Body& a, const Body& b) {
  return b.grid && !b.fabric &&
         spring_grid(*a.grid, a.material(), 0) == spring_grid(*b.grid, b.material(), 0);
}

}  // namespace

std::uint32_t equal_grids(std::span<const Body> bodies, std::size_t most) {
  std::uint32_t count = 1;
  while (count < std::min(bodies.size(), most) && equal(bodies[0], bodies[count])) ++count;
  return count;
}

}  // namespace weft
