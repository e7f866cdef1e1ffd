#include "method/multigrid/systems.hpp"

namespace weft::multigrid {

std::vector<SystemBodies> systems_of(const Model& model) {
  const std::span<const Body> bodies = model.bodies;
  std::vector<SystemBodies> made;
  for (std::size_t b = 0; b < bodies.size();) {
    std::size_t end = b + 1;
    while (bodies[b].solid && end < bodies.size() && bodies[end].solid) ++end;
    made.push_back({bodies.subspan(b, end - b)});
    b = end;
  }
  return made;
}

}  // namespace weft::multigrid
