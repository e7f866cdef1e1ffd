// When the linear system of an implicit substep counts as solved. Mirror: src/method/multigrid/solve.wgsl.
#pragma once

#include <cstdint>

namespace weft::multigrid {

/// Of the wanted residual: so much of what the guess leaves is enough.
inline constexpr double kGuessPart = 10;
/// No substep takes more iterations.
inline constexpr std::uint32_t kMostIterations = 64;
/// Nor, where obstacles may hold nodes, more than this, and it begins without a guess: the test of sticking or sliding
/// reads speeds, and what solved systems leave of elastic waves makes strips creep that friction should hold.
inline constexpr std::uint32_t kMostHeldIterations = 1;

}  // namespace weft::multigrid
