#include "mesh/morton_order.hpp"

#include <algorithm>
#include <utility>

namespace weft::mesh {
namespace {

/// Moves bit i of ten bits to bit 3 i.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t spread = 0;
  for (std::uint32_t i = 0; i < 10; ++i) spread |= ((bits >> i) & 1U) << (3 * i);
  return spread;
}

struct Range {
  Vec3d low;
  double size = 1;  // the same along all axes, so that cells are cubes

  explicit Range(std::span<const Vec3d> points) {
    if (points.empty()) return;
    Vec3d high = points[0];
    low = points[0];
    for (const Vec3d& p : points) {
      low = min(low, p);
      high = max(high, p);
    }
    const Vec3d extent = high - low;
    size = std::max({extent.x, extent.y, extent.z, 1e-300});
  }
  std::uint32_t key(const Vec3d& p) const {
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = 1023 * (p[axis] - low[axis]) / size;
      key |= spread(static_cast<std::uint32_t>(std::clamp(place, 0.0, 1023.0))) << axis;
    }
    return key;
  }
};

}  // namespace

std::vector<std::uint32_t> morton_order(std::span<const Vec3d> points) {
  const Range range(points);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
  keys.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) keys.push_back({range.key(points[i]), i});
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, index] : keys) order.push_back(index);
  return order;
}

}  // namespace weft::mesh
