#include "contact/reference/proximity/may_meet.hpp"

#include <algorithm>

#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/proximity/separate.hpp"

namespace weft::reference {
namespace {

using Corners = std::array<Vec3d, 4>;  // of A, then of B

/// How far A is beyond B in what `along` says of each corner [m].
template <class Along>
double apart(const ClothPair& pair, const Along& along) {
  BothSides sides{pair.count_a, pair.count_b};
  for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k) sides.along[k] = along(k);
  return sides.apart();
}

}  // namespace

bool may_meet(const ClothPair& pair, std::span<const Vec3d> start, std::span<const Vec3d> end) {
  Corners from, to;  // seen from the first, as the middle of cloth may be far from the origin
  for (std::uint32_t k = 0; k < pair.count_a + pair.count_b; ++k) {
    from[k] = start[pair.nodes[k]] - start[pair.nodes[0]];
    to[k] = end[pair.nodes[k]] - start[pair.nodes[0]];
  }
  if (apart(pair, [&](std::uint32_t k) { return dot(pair.normal, to[k]); }) >= pair.apart) return false;
  const Vec3d offset = offset_between(pair.count_a, pair.count_b, to);
  if (!(length(offset) > 0)) return true;
  const Vec3d then = offset / length(offset);
  const double at_end = apart(pair, [&](std::uint32_t k) { return dot(then, to[k]); });
  const double between_ends =
      0.5 * apart(pair, [&](std::uint32_t k) { return dot(pair.normal, to[k]) + dot(then, from[k]); });
  return std::min(at_end, between_ends) < pair.apart;
}

}  // namespace weft::reference
