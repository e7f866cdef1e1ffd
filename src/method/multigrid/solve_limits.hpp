// When the linear system of an implicit substep counts as solved. Mirror: src/method/multigrid/solve.wgsl.
#pragma once

#include <cstdint>

namespace weft::multigrid {

/// Of the wanted residual: so much of what the guess leaves is enough.
inline constexpr double kGuessPart = 10;
/// Of the first of several systems, with contact or by Newton's method: it needs no smaller residual, and takes no more
/// iterations.
inline constexpr double kFirstPart = 0.1;
inline constexpr std::uint32_t kFirstIterations = 2;
/// The last system of a substep takes no more.
inline constexpr std::uint32_t kMostIterations = 64;
/// Where obstacles may hold nodes, this part of the wanted residual: what is left brakes what slides as a whole. A
/// strip over a capsule, a seventh more than friction holds, goes 19 cm in two thirds of a second, and 9 without this.
inline constexpr double kHeldPart = 0.1;

}  // namespace weft::multigrid
