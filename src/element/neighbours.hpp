#pragma once

#include <cstdint>
#include <vector>

#include "model/host_model.hpp"

namespace weft {

/// One spring as one of its nodes sees it. Mirror: shaders/shared/neighbour.wgsl.
struct Neighbour {
  std::uint32_t node = 0;
  float rest_length = 0;  // [m]
  float stiffness = 0;    // [N/m]
  float damping = 0;      // [N·s/m]
};
static_assert(sizeof(Neighbour) == 16);

/// The springs of nodes first … first + count - 1: node first + i has entries[offsets[i]] up to
/// entries[offsets[i + 1]], in the order of the springs.
struct Neighbours {
  std::vector<std::uint32_t> offsets;
  std::vector<Neighbour> entries;
};
Neighbours build_neighbours(const std::vector<Spring>& springs, std::uint32_t first, std::uint32_t count);

}  // namespace weft
