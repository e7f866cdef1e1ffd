// The tree over the object triangles that bvh.wgsl traverses: four children per node, boxes exact in f32.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/pushes/object_triangles.hpp"

namespace weft::contact {

/// Mirror of TreeNode in src/contact/pushes/bvh.wgsl.
struct TreeNode {
  std::array<std::array<float, 4>, 3> low{}, high{};  // [axis][child], m
  std::array<std::uint32_t, 4>
      child{};  // 8 * a leaf's first triangle + their number; 8 * an inner node; 0: none
  std::array<std::uint32_t, 4> spare{};  // fills the node up to a cache line

  bool empty(std::size_t k) const { return child[k] == 0; }
  bool leaf(std::size_t k) const { return count(k) > 0; }
  bool inner(std::size_t k) const { return count(k) == 0 && child[k] > 0; }
  std::uint32_t count(std::size_t k) const { return child[k] % 8; }
  std::uint32_t index(std::size_t k) const { return child[k] / 8; }
};
static_assert(sizeof(TreeNode) == 128 && offsetof(TreeNode, high) == 48 && offsetof(TreeNode, child) == 96);

struct ObjectTree {
  std::vector<TreeNode> nodes;            // the root is the first; depth first
  std::vector<ObjectTriangle> triangles;  // leaf after leaf
  std::vector<std::uint32_t> ids;         // the number of each in the input
  std::uint32_t stack_size = 0;           // entries that a walk needs at most, whatever it looks for
};

/// Entries of a walk's stack in bvh.wgsl, and in walk.wgsl beyond those of a walk that takes many at once; the same
/// number as there.
///
/// Why it suffices. A walk pops a node and pushes its inner children in their order, so the last is walked
/// first, and child k is walked while k others wait. Where all boxes are hit a node needs max over k of (k +
/// need of child k), at least 1. Children are sorted by decreasing need, the costliest first and hence walked last.
/// Let N(s) be the least number of inner nodes that need s entries. The child that decides, at place k > 0,
/// needs s - k, and the k before it no less: N(s) >= min(2 N(s - 1), 3 N(s - 2), 4 N(s - 3)), N(1) = 1, so
/// N(s) >= 4^((s - 1) / 3) by induction. To need 33 takes 4^(32 / 3) = 2.6 million nodes; a binding of 128
/// MiB holds 1.05 million. On an adapter with larger bindings PairsBvh::create refuses a tree that needs
/// more.
inline constexpr std::uint32_t kStackSize = 32;

/// A surface-area tree collapsed to four children per node: the largest of a node's children are opened first.
ObjectTree build_object_tree(std::span<const ObjectTriangle> triangles);

}  // namespace weft::contact
