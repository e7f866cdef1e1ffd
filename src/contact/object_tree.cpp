#include "contact/object_tree.hpp"

#include <algorithm>
#include <limits>

#include "contact/binary_tree.hpp"

namespace weft::contact {
namespace {

void set_box(TreeNode& node, std::size_t k, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.low[axis][k] = box.low[static_cast<int>(axis)];
    node.high[axis][k] = box.high[static_cast<int>(axis)];
  }
}

class Collapse {
 public:
  Collapse(const BinaryTree& binary, ObjectTree& tree) : binary_(binary), tree_(tree) {}

  /// Adds the node that represents the binary node, and those below it; returns the stack that it needs.
  std::uint32_t add(std::uint32_t binary_index) {
    std::vector<std::uint32_t> children = open(binary_index);
    const std::size_t index = tree_.nodes.size();
    tree_.nodes.push_back({});
    // Each child is made first, then sorted by its need: inner nodes by falling need, then leaves.
    struct Made {
      std::uint32_t binary = 0, node = 0, need = 0;
    };
    std::vector<Made> made;
    for (const std::uint32_t child : children) {
      const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
      made.push_back({child, node, binary_.nodes[child].leaf() ? 0 : add(child)});
    }
    std::stable_sort(made.begin(), made.end(), [](const Made& a, const Made& b) { return a.need > b.need; });
    TreeNode& node = tree_.nodes[index];
    constexpr float kLargest = std::numeric_limits<float>::max();
    std::uint32_t need = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k >= made.size()) {  // no box overlaps an inverted one
        set_box(node, k, {{kLargest, kLargest, kLargest}, {-kLargest, -kLargest, -kLargest}});
        continue;
      }
      const BinaryNode& child = binary_.nodes[made[k].binary];
      set_box(node, k, child.box);
      node.child[k] = 8 * (child.leaf() ? child.first : made[k].node) + child.count;
      if (!child.leaf()) need = std::max(need, static_cast<std::uint32_t>(k) + made[k].need);
    }
    return need;
  }

 private:
  /// Up to four binary nodes with the same triangles as this one.
  std::vector<std::uint32_t> open(std::uint32_t index) const {
    std::vector<std::uint32_t> children = {index};
    while (children.size() < 4) {
      auto best = children.end();
      for (auto it = children.begin(); it != children.end(); ++it)
        if (!binary_.nodes[*it].leaf() &&
            (best == children.end() || area(binary_.nodes[*it].box) > area(binary_.nodes[*best].box)))
          best = it;
      if (best == children.end()) break;
      const BinaryNode& node = binary_.nodes[*best];
      *best = node.left;
      children.push_back(node.right);
    }
    return children;
  }

  const BinaryTree& binary_;
  ObjectTree& tree_;
};

}  // namespace

ObjectTree build_object_tree(std::span<const ObjectTriangle> triangles) {
  ObjectTree tree;
  const BinaryTree binary = build_binary_tree(triangles);
  for (const std::uint32_t id : binary.order) {
    tree.triangles.push_back(triangles[id]);
    tree.ids.push_back(id);
  }
  if (!triangles.empty()) tree.stack_size = Collapse(binary, tree).add(0);
  return tree;
}

}  // namespace weft::contact
