#include "contact/reference/pushes/contact_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

TrianglePoints corners(const mesh::Triangle& triangle, std::span<const Vec3d> positions) {
  return {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]};
}

bool finite(const TrianglePoints& t) {
  for (const Vec3d& p : {t.a, t.b, t.c})
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  return true;
}

}  // namespace

ObjectTriangles::ObjectTriangles(const mesh::TriangleMesh& object) {
  for (std::uint32_t t = 0; t < object.triangles.size(); ++t) {
    points_.push_back(points_of(object, t));
    boxes_.push_back(box_of(points_.back()));
  }
  tree_ = BoxTree(boxes_);
}

std::vector<TrianglePair> ObjectTriangles::pairs(std::span<const mesh::Triangle> cloth,
                                                 std::span<const Vec3d> positions) const {
  std::vector<TrianglePair> found;
  for (std::uint32_t c = 0; c < cloth.size(); ++c) {
    const TrianglePoints points = corners(cloth[c], positions);
    if (!finite(points)) continue;
    const Box query = query_box(points);
    const std::size_t before = found.size();
    tree_.overlapping(query, [&](std::uint32_t o) {
      if (triangles_cross(points, points_[o])) found.push_back({c, o});
    });
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
