// A bounding-volume hierarchy over anything that has a box: it prunes most tests of pairs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace weft::reference {

/// An axis-aligned box [m].
struct Box {
  Vec3d low, high;
};
bool overlap(const Box& a, const Box& b);
Box around(const Box& a, const Box& b);
bool finite(const Box& box);
/// How far two boxes are apart, 0 where they overlap [m]. No points of the two are nearer.
double distance(const Box& a, const Box& b);

/// The halves of a range of boxes, cut at the middle along the longest side, down to four. Boxes that are not
/// finite are left out.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(index) for all boxes that overlap the query, in the order of the tree.
  template <class Visit>
  void overlapping(const Box& query, Visit visit) const {
    walk([&](const Box& box) { return overlap(query, box); }, visit);
  }
  /// Calls visit(index) for all boxes that are at most `radius` from the query. The walk reads the radius
  /// again at each box, so that a search for the nearest can shrink it on the way.
  template <class Visit>
  void within(const Box& query, const double& radius, Visit visit) const {
    walk([&](const Box& box) { return distance(query, box) <= radius; }, visit);
  }

 private:
  /// Nodes are in depth-first order, left child first: a subtree is skipped by continuing at
  /// `after`.
  struct Node {
    Box box;
    std::uint32_t after = 0;             // the next node that is not below this one
    std::uint32_t first = 0, count = 0;  // of a leaf: boxes in order_; count is 0 where there are halves
  };

  void build(std::uint32_t first, std::uint32_t count);

  template <class Wanted, class Visit>
  void walk(Wanted wanted, Visit visit) const {
    for (std::uint32_t n = 0; n < nodes_.size();) {
      const Node& node = nodes_[n];
      const bool enter = wanted(node.box);
      n = enter ? n + 1 : node.after;
      if (!enter) continue;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (wanted(boxes_[order_[i]])) visit(order_[i]);
    }
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace weft::reference
