// The plane before a solid side that a pair keeps to which slides along it, in double.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.hpp"

namespace weft::reference {

/// Where the corners of a pair are at the start of a substep and at its end, of A, then of B: a vertex and a
/// triangle, or two edges.
struct MovingPair {
  std::uint32_t count_a = 0, count_b = 0;
  std::array<Vec3d, 4> start{}, end{};  // [m]
};

/// The direction, from B to A, along which the sides are to stay apart: docs/contact.md, equation (6j). `normal`: that
/// between the closest points at the start; `margin`: how far apart they have to be there [m].
Vec3d turned_normal(const MovingPair& pair, const Vec3d& normal, double distance, double margin);

}  // namespace weft::reference
