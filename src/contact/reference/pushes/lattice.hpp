// The narrow phase in integers: exact, for coordinates on a lattice.
#pragma once

#include <array>
#include <cstdint>

namespace weft::reference {

/// The largest coordinate difference for which the f32 test is exact, by its tolerance (triangle_pair.wgsl).
inline constexpr std::int64_t kLatticeExtent = 44;
static_assert(3.0 * 64 / (1U << 24U) * kLatticeExtent * kLatticeExtent * kLatticeExtent < 1,
              "a tolerance below 1 tells integers apart");
static_assert(6 * kLatticeExtent * kLatticeExtent * kLatticeExtent < (1 << 24),
              "f32 holds every determinant");

using LatticePoint = std::array<std::int64_t, 3>;
using LatticeTriangle = std::array<LatticePoint, 3>;

/// Whether the open segment meets the closed triangle in a point, not along a line (parallel ones miss).
bool segment_meets(const LatticePoint& from, const LatticePoint& to, const LatticeTriangle& triangle);
/// Whether an edge of either triangle meets the other.
bool triangles_meet(const LatticeTriangle& a, const LatticeTriangle& b);

}  // namespace weft::reference
