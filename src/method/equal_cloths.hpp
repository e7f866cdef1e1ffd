#pragma once

#include <cstdint>
#include <span>

#include "model/model.hpp"

namespace weft {

/// Cloths that are equal, one behind the other among the bodies: a dispatch does the same for all of them, a cloth a
/// layer along its z.
struct EqualCloths {
  const Body& first;
  std::uint32_t count = 1;
};

/// How many of these bodies, from the first on, which is a grid, are grids that differ from it in nothing but the place
/// and the motion of their vertices, as copies of a cloth do: at least 1, and else no more than `most`.
std::uint32_t equal_grids(std::span<const Body> bodies, std::size_t most);

}  // namespace weft
