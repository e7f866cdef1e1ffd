// Separates two sides of cloth along a direction, in double. Source: docs/contact.md, equation (6d).
#pragma once

#include <array>
#include <cstdint>

namespace weft::reference {

/// Up to four vertices of two sides, those of A first.
struct BothSides {
  std::uint32_t count_a = 0, count_b = 0;
  std::array<double, 4> along{};  // from B to A, where they would end [m]
  std::array<double, 4> mass{};   // 0: it does not move [kg]
  std::array<bool, 4> stays{};    // of these: the other side gives way

  /// How far A is beyond B [m].
  double apart() const;
};

/// How far each vertex is moved along the direction [m], so that side A ends `apart` [m] beyond side B: those of A that
/// are short of a plane forward, those of B that are beyond it back. The plane lies where that adds no momentum, and
/// before vertices that stay. One that neither moves nor stays is left where it is.
std::array<double, 4> separated(const BothSides& sides, double apart);

}  // namespace weft::reference
