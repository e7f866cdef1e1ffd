#include "element/neighbours.hpp"

namespace weft {

Neighbours build_neighbours(const std::vector<Spring>& springs, std::uint32_t first, std::uint32_t count) {
  Neighbours built;
  built.offsets.assign(count + 1UL, 0);
  for (const Spring& spring : springs) {
    ++built.offsets[spring.node_a - first + 1];
    ++built.offsets[spring.node_b - first + 1];
  }
  for (std::uint32_t i = 0; i < count; ++i) built.offsets[i + 1] += built.offsets[i];
  built.entries.resize(2 * springs.size());
  std::vector<std::uint32_t> next(built.offsets.begin(), built.offsets.end() - 1);
  for (const Spring& s : springs) {
    built.entries[next[s.node_a - first]++] = {s.node_b, s.rest_length, s.stiffness, s.damping};
    built.entries[next[s.node_b - first]++] = {s.node_a, s.rest_length, s.stiffness, s.damping};
  }
  return built;
}

}  // namespace weft
