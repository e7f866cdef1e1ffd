#include "contact/reference/box_tree.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

constexpr std::uint32_t kLeaf = 4;  // boxes

}  // namespace

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

Box around(const Box& a, const Box& b) { return {min(a.low, b.low), max(a.high, b.high)}; }

bool finite(const Box& box) {
  for (const Vec3d& p : {box.low, box.high})
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  return true;
}

double distance(const Box& a, const Box& b) {
  return length(max(max(a.low - b.high, b.low - a.high), Vec3d{}));
}

BoxTree::BoxTree(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    if (finite(boxes_[i])) order_.push_back(i);
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

void BoxTree::build(std::uint32_t first, std::uint32_t count) {
  Box box = boxes_[order_[first]];
  for (std::uint32_t i = first; i < first + count; ++i) box = around(box, boxes_[order_[i]]);
  const std::size_t node = nodes_.size();
  nodes_.push_back({box, 0, first, count <= kLeaf ? count : 0});
  if (count > kLeaf) {
    const Vec3d size = box.high - box.low;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const auto middle = [&](std::uint32_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
    const auto start = order_.begin() + first;
    std::nth_element(start, start + count / 2, start + count, [&](std::uint32_t a, std::uint32_t b) {
      return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
    });
    build(first, count / 2);
    build(first + count / 2, count - count / 2);
  }
  nodes_[node].after = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace weft::reference
