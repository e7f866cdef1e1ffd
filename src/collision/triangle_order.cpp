#include "collision/triangle_order.hpp"

#include <algorithm>
#include <utility>

namespace weft::collision {
namespace {

/// Moves bit i of ten bits to bit 3 i.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t spread = 0;
  for (std::uint32_t i = 0; i < 10; ++i) spread |= ((bits >> i) & 1U) << (3 * i);
  return spread;
}

struct Range {
  Vec3d low, size;  // size: the same along all axes, so that cells are cubes

  explicit Range(std::span<const Vec3d> points) {
    if (points.empty()) return;
    Vec3d high = points[0];
    low = points[0];
    for (const Vec3d& p : points) {
      low = min(low, p);
      high = max(high, p);
    }
    const Vec3d extent = high - low;
    const double largest = std::max({extent.x, extent.y, extent.z, 1e-300});
    size = {largest, largest, largest};
  }
  std::uint32_t key(const Vec3d& p) const {
    std::uint32_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = 1023 * (p[axis] - low[axis]) / size[axis];
      key |= spread(static_cast<std::uint32_t>(std::clamp(place, 0.0, 1023.0))) << axis;
    }
    return key;
  }
};

void append_sorted(std::span<const Vec3d> centres, std::uint32_t first, std::vector<std::uint32_t>& order) {
  const Range range(centres);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
  for (std::uint32_t t = 0; t < centres.size(); ++t) keys.push_back({range.key(centres[t]), first + t});
  std::sort(keys.begin(), keys.end());
  for (const auto& [key, triangle] : keys) order.push_back(triangle);
}

}  // namespace

std::vector<std::uint32_t> cloth_order(const HostModel& model) {
  std::vector<std::uint32_t> order;
  for (const ClothModel& cloth : model.cloths) {
    std::vector<Vec3d> centres;
    for (std::uint32_t t = 0; t < cloth.triangle_count; ++t) {
      Vec3d centre;
      for (const std::uint32_t vertex : model.triangles[cloth.first_triangle + t])
        centre += Vec3d{model.uv[vertex][0], model.uv[vertex][1], 0};
      centres.push_back(centre);
    }
    append_sorted(centres, cloth.first_triangle, order);
  }
  return order;
}

std::vector<std::uint32_t> mesh_order(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> centres;
  for (const mesh::Triangle& t : mesh.triangles) {
    Vec3d centre;
    for (const std::uint32_t vertex : t) centre += mesh.positions[vertex].to<double>();
    centres.push_back(centre);
  }
  std::vector<std::uint32_t> order;
  append_sorted(centres, 0, order);
  return order;
}

}  // namespace weft::collision
