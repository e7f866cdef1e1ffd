// Triangles that pass through each other.
#include <algorithm>

#include "contact/reference/proximity/audit.hpp"
#include "mesh/orientation.hpp"

namespace weft::reference {
namespace {

bool shares(const mesh::Triangle& triangle, std::uint32_t a, std::uint32_t b) {
  return std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) { return v == a || v == b; });
}

/// Whether an edge of one triangle crosses the other. `one_mesh`: vertices of both count in one list.
bool edges_cross(const Surfaces& from, const mesh::Triangle& edges, const Surfaces& onto,
                 const mesh::Triangle& face, bool one_mesh) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t p = edges[k], q = edges[(k + 1) % 3];
    if (one_mesh && shares(face, p, q)) continue;
    if (segment_crosses(from.positions[p], from.positions[q], onto.positions[face[0]],
                        onto.positions[face[1]], onto.positions[face[2]]))
      return true;
  }
  return false;
}

bool cross_each_other(const Surfaces& a, std::uint32_t of_a, const Surfaces& b, std::uint32_t of_b,
                      bool one_mesh) {
  const mesh::Triangle &first = a.triangles[of_a], &second = b.triangles[of_b];
  return edges_cross(a, first, b, second, one_mesh) || edges_cross(b, second, a, first, one_mesh);
}

std::vector<Box> boxes_of(const Surfaces& surfaces) {
  std::vector<Box> boxes;
  for (const mesh::Triangle& triangle : surfaces.triangles)
    boxes.push_back(box_of(surfaces.positions, triangle));
  return boxes;
}

std::vector<Crossing> all_crossings(const Surfaces& a, const Surfaces& b, bool one_mesh) {
  const std::vector<Box> boxes = boxes_of(a);
  const BoxTree tree(one_mesh ? boxes : boxes_of(b));
  std::vector<Crossing> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!finite(boxes[i])) continue;
    tree.overlapping(boxes[i], [&](std::uint32_t j) {
      if ((!one_mesh || i < j) && cross_each_other(a, i, b, j, one_mesh)) found.push_back({i, j});
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Crossing> all_by_brute_force(const Surfaces& a, const Surfaces& b, bool one_mesh) {
  const std::vector<Box> of_a = boxes_of(a), of_b = boxes_of(b);
  std::vector<Crossing> found;
  for (std::uint32_t i = 0; i < of_a.size(); ++i)
    for (std::uint32_t j = one_mesh ? i + 1 : 0; j < of_b.size(); ++j)
      if (finite(of_a[i]) && finite(of_b[j]) && cross_each_other(a, i, b, j, one_mesh))
        found.push_back({i, j});
  return found;
}

}  // namespace

bool segment_crosses(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const int side = mesh::orientation(a, b, c, p);
  if (side == 0 || mesh::orientation(a, b, c, q) != -side) return false;
  const int first = mesh::orientation(p, q, a, b);
  return first != 0 && mesh::orientation(p, q, b, c) == first && mesh::orientation(p, q, c, a) == first;
}

std::vector<Crossing> crossings(const Surfaces& cloth, const Surfaces& object) {
  return all_crossings(cloth, object, false);
}
std::vector<Crossing> self_crossings(const Surfaces& cloth) { return all_crossings(cloth, cloth, true); }
std::vector<Crossing> crossings_by_brute_force(const Surfaces& cloth, const Surfaces& object) {
  return all_by_brute_force(cloth, object, false);
}
std::vector<Crossing> self_crossings_by_brute_force(const Surfaces& cloth) {
  return all_by_brute_force(cloth, cloth, true);
}

}  // namespace weft::reference
