#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "contact/binary_tree.hpp"
#include "contact/object_tree.hpp"
#include "mesh/primitives.hpp"

using namespace weft;
using namespace weft::contact;

namespace {

ObjectTriangle triangle_at(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  return {Vec4f::from(a, 0), Vec4f::from(b, 0), Vec4f::from(c, 1)};
}

std::vector<ObjectTriangle> scattered(std::uint32_t count, std::uint64_t seed, double size) {
  Random random(seed);
  const auto point = [&](double range) {
    return Vec3d{random.uniform(-range, range), random.uniform(-range, range), random.uniform(-range, range)};
  };
  std::vector<ObjectTriangle> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3d center = point(1);
    triangles.push_back(triangle_at((center + point(size)).to<float>(), (center + point(size)).to<float>(),
                                    (center + point(size)).to<float>()));
  }
  return triangles;
}

Box child_box(const TreeNode& node, std::size_t k) {
  return {{node.low[0][k], node.low[1][k], node.low[2][k]},
          {node.high[0][k], node.high[1][k], node.high[2][k]}};
}

/// Walks as the kernel does, all boxes hit: counts triangles and nodes, checks boxes, gives the largest
/// stack.
struct Walk {
  const ObjectTree& tree;
  std::vector<std::uint32_t> seen;  // how often each triangle was in a leaf
  std::vector<std::uint32_t> visits;
  std::size_t largest_stack = 0;

  explicit Walk(const ObjectTree& tree_)
      : tree(tree_), seen(tree_.triangles.size()), visits(tree_.nodes.size()) {
    std::vector<std::pair<std::uint32_t, Box>> stack;
    constexpr float kAll = std::numeric_limits<float>::max();
    if (!tree.nodes.empty()) stack.push_back({0, {{-kAll, -kAll, -kAll}, {kAll, kAll, kAll}}});
    while (!stack.empty()) {
      largest_stack = std::max(largest_stack, stack.size());
      const auto [index, box] = stack.back();
      stack.pop_back();
      ++visits[index];
      visit(tree.nodes[index], box, stack);
    }
  }

  void visit(const TreeNode& node, const Box& box, std::vector<std::pair<std::uint32_t, Box>>& stack) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (node.empty(k)) continue;
      const Box child = child_box(node, k);
      CHECK(box.contains(child));
      if (node.inner(k)) {
        stack.push_back({node.index(k), child});
        continue;
      }
      CHECK(node.count(k) <= kLeafTriangles);
      for (std::uint32_t t = node.index(k); t < node.index(k) + node.count(k); ++t) {
        ++seen[t];
        CHECK(child.contains(box_of(tree.triangles[t])));
      }
    }
  }
};

void check_tree(const std::vector<ObjectTriangle>& triangles) {
  const ObjectTree tree = build_object_tree(triangles);
  const Walk walk(tree);
  REQUIRE(tree.triangles.size() == triangles.size());
  CHECK(std::all_of(walk.seen.begin(), walk.seen.end(), [](std::uint32_t n) { return n == 1; }));
  CHECK(std::all_of(walk.visits.begin(), walk.visits.end(), [](std::uint32_t n) { return n == 1; }));
  CHECK(walk.largest_stack == tree.stack_size);  // the host's bound is what a walk of everything needs
  CHECK(tree.stack_size <= kStackSize);
  std::vector<std::uint32_t> ids = tree.ids;
  std::sort(ids.begin(), ids.end());
  for (std::uint32_t i = 0; i < ids.size(); ++i) CHECK(ids[i] == i);
  for (std::uint32_t i = 0; i < tree.ids.size(); ++i) CHECK(tree.triangles[i].a == triangles[tree.ids[i]].a);
}

std::uint32_t depth(const BinaryTree& tree, std::uint32_t node) {
  const BinaryNode& n = tree.nodes[node];
  return n.leaf() ? 0 : 1 + std::max(depth(tree, n.left), depth(tree, n.right));
}

}  // namespace

TEST_CASE("each triangle is in exactly one leaf, in boxes that hold it, for every number of triangles") {
  for (const std::uint32_t count :
       {0U,  1U,  2U,   3U,   4U,   5U,    8U,    9U,    16U,    17U,    31U,
        32U, 33U, 255U, 256U, 257U, 2047U, 2048U, 2049U, 16383U, 16384U, 16385U}) {
    CAPTURE(count);
    check_tree(scattered(count, count, 0.05));
  }
}

TEST_CASE(
    "triangles that no plane parts still end in leaves of four, at a depth that grows with the logarithm") {
  const std::vector<ObjectTriangle> same(5000, triangle_at({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  check_tree(same);
  CHECK(depth(build_binary_tree(same), 0) <= 11);  // 5000 / 4 < 2^11
}

TEST_CASE(
    "sizes that shrink by half, the worst for the surface area heuristic, stay within the depth and the "
    "stack") {
  std::vector<ObjectTriangle>
      shrinking;  // 16 bins part four sizes from the rest at a time: 60 levels without a limit
  for (int i = 0; i < 240; ++i) {
    const float x = std::ldexp(1.0F, 120 - i);
    for (int copy = 0; copy < 6; ++copy)
      shrinking.push_back(triangle_at({x, 0, 0}, {1.5F * x, 0, 0}, {x, x, 0}));
  }
  check_tree(shrinking);
  CHECK(depth(build_binary_tree(shrinking), 0) <= 40 + 11);
}

TEST_CASE("a tree over a sphere keeps a walk short") {
  const mesh::TriangleMesh sphere = mesh::make_sphere(100, 100);
  const mesh::TriangleMesh objects[] = {sphere};
  auto triangles = object_triangles(objects);
  REQUIRE(triangles);
  check_tree(*triangles);
  CHECK(build_object_tree(*triangles).nodes.size() < triangles->size() / 4);
  for (const ObjectTriangle& t : *triangles) {
    const Vec3f center = (t.a.xyz() + t.b.xyz() + t.c.xyz()) / 3.0F;
    CHECK(dot(t.normal(), center) > 0);  // outward
    CHECK(std::abs(length(t.normal()) - 1) < 1e-6F);
  }
}

TEST_CASE("triangles without area or with coordinates that are not finite are refused by their number") {
  mesh::TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  const auto flat = object_triangles(std::vector{mesh::make_sphere(3, 2), mesh});
  REQUIRE_FALSE(flat);
  CHECK(flat.error().message == "Triangle 1 of collider mesh 1 has no area.");
  mesh.triangles.pop_back();
  CHECK(object_triangles(std::vector{mesh}));
  mesh.positions[1].x = std::numeric_limits<float>::infinity();
  const auto infinite = object_triangles(std::vector{mesh});
  REQUIRE_FALSE(infinite);
  CHECK(infinite.error().message == "Triangle 0 of collider mesh 0 has a coordinate that is not finite.");
}
