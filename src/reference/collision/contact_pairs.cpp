#include "reference/collision/contact_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft::reference {
namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles

TrianglePoints corners(const mesh::Triangle& triangle, std::span<const Vec3d> positions) {
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}

bool finite(const TrianglePoints& t) {
  for (const Vec3d& p : {t.a, t.b, t.c})
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  return true;
}

}  // namespace

ObjectTriangles::ObjectTriangles(const mesh::TriangleMesh& object) : order_(object.triangles.size()) {
  for (std::uint32_t t = 0; t < object.triangles.size(); ++t) {
    points_.push_back(points_of(object, t));
    boxes_.push_back(box_of(points_.back()));
  }
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void ObjectTriangles::build(std::uint32_t first, std::uint32_t count) {
  Box box = boxes_[order_[first]];
  for (std::uint32_t i = first; i < first + count; ++i)
    box = {min(box.low, boxes_[order_[i]].low), max(box.high, boxes_[order_[i]].high)};
  const std::size_t node = nodes_.size();
  nodes_.push_back({box, 0, first, count <= kLeaf ? count : 0});
  if (count > kLeaf) {
    const Vec3d size = box.high - box.low;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const auto middle = [&](std::uint32_t t) { return boxes_[t].low[axis] + boxes_[t].high[axis]; };
    const auto start = order_.begin() + first;
    std::nth_element(start, start + count / 2, start + count, [&](std::uint32_t a, std::uint32_t b) {
      return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
    });
    build(first, count / 2);
    build(first + count / 2, count - count / 2);
  }
  nodes_[node].after = static_cast<std::uint32_t>(nodes_.size());
}

std::vector<TrianglePair> ObjectTriangles::pairs(std::span<const mesh::Triangle> cloth,
                                                 std::span<const Vec3d> positions) const {
  std::vector<TrianglePair> found;
  for (std::uint32_t c = 0; c < cloth.size(); ++c) {
    const TrianglePoints points = corners(cloth[c], positions);
    if (!finite(points)) continue;
    const Box query = query_box(points);
    const std::size_t before = found.size();
    for (std::uint32_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      const bool near = overlap(query, node.box);
      n = near ? n + 1 : node.after;
      if (!near) continue;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const std::uint32_t o = order_[i];
        if (overlap(query, boxes_[o]) && triangles_cross(points, points_[o])) found.push_back({c, o});
      }
    }
    // Pushes are summed in this order: sorted, the sums do not depend on the tree.
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
  }
  return found;
}

std::vector<TrianglePair> ObjectTriangles::pairs_by_brute_force(std::span<const mesh::Triangle> cloth,
                                                                std::span<const Vec3d> positions) const {
  std::vector<TrianglePair> found;
  for (std::uint32_t c = 0; c < cloth.size(); ++c) {
    const TrianglePoints points = corners(cloth[c], positions);
    if (!finite(points)) continue;
    const Box query = query_box(points);
    for (std::uint32_t o = 0; o < points_.size(); ++o)
      if (overlap(query, boxes_[o]) && triangles_cross(points, points_[o])) found.push_back({c, o});
  }
  return found;
}

}  // namespace weft::reference
