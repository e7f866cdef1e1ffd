// A binary tree of boxes by the surface area heuristic, from which object_tree.hpp makes the one that kernels
// read.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/pushes/object_triangles.hpp"

namespace weft::contact {

/// Half the surface, which is all that costs are compared by [m²].
double area(const Box& box);

inline constexpr std::uint32_t kLeafTriangles = 4;  // at most

/// `left` and `right` are inner nodes' children; a leaf has `count` > 0 and order[first .. first + count).
struct BinaryNode {
  Box box;
  std::uint32_t left = 0, right = 0;
  std::uint32_t first = 0, count = 0;

  bool leaf() const { return count > 0; }
};

struct BinaryTree {
  std::vector<BinaryNode> nodes;     // the root is the first; none without triangles
  std::vector<std::uint32_t> order;  // triangle numbers, leaf after leaf, rising inside a leaf
};

/// Splits at the cheapest of 16 planes on each axis (Wald 2007, On fast Construction of SAH-based Bounding
/// Volume Hierarchies) until at most kLeafTriangles are left. Past 40 levels it halves by number, so that the
/// depth is at most 40 + log2(triangles) whatever the input. The same tree on every machine.
BinaryTree build_binary_tree(std::span<const ObjectTriangle> triangles);

}  // namespace weft::contact
