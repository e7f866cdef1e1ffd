#include "contact/reference/pushes/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

struct TriangleBox {
  Vec3f low, high;
};

TriangleBox box_of(const mesh::TriangleMesh& mesh, std::uint32_t triangle) {
  const mesh::Triangle& t = mesh.triangles[triangle];
  const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  return {min(min(a, b), c), max(max(a, b), c)};
}

bool overlap(const TriangleBox& a, const TriangleBox& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

TriangleBox grown(const TriangleBox& box) {
  float size = 0;
  for (int axis = 0; axis < 3; ++axis)
    size = std::max({size, std::abs(box.low[axis]), std::abs(box.high[axis])});
  const float growth = size / (1U << 20U);
  return {box.low - Vec3f{growth, growth, growth}, box.high + Vec3f{growth, growth, growth}};
}

bool finite(const mesh::TriangleMesh& mesh, std::uint32_t triangle) {
  for (const std::uint32_t vertex : mesh.triangles[triangle])
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(mesh.positions[vertex][axis])) return false;
  return true;
}

}  // namespace

TrianglePoints points_of(const mesh::TriangleMesh& mesh, std::uint32_t triangle) {
  const mesh::Triangle& t = mesh.triangles[triangle];
  return {mesh.positions[t[0]].to<double>(), mesh.positions[t[1]].to<double>(),
          mesh.positions[t[2]].to<double>()};
}

PairList find_pairs(const mesh::TriangleMesh& cloth, const mesh::TriangleMesh& object) {
  std::vector<TriangleBox> boxes;
  for (std::uint32_t o = 0; o < object.triangles.size(); ++o) boxes.push_back(box_of(object, o));
  PairList list;
  for (std::uint32_t c = 0; c < cloth.triangles.size(); ++c) {
    if (!finite(cloth, c)) continue;
    const TriangleBox query = grown(box_of(cloth, c));
    for (std::uint32_t o = 0; o < boxes.size(); ++o) {
      if (!overlap(query, boxes[o])) continue;
      ++list.candidates;
      const Verdict verdict = triangle_pair(points_of(cloth, c), points_of(object, o));
      if (verdict == Verdict::Hit) list.hits.push_back({c, o});
      if (verdict == Verdict::Ambiguous) list.ambiguous.push_back({c, o});
    }
  }
  return list;
}

}  // namespace weft::reference
