#include "contact/reference/proximity/audit.hpp"

#include <algorithm>
#include <limits>

#include "contact/reference/proximity/closest.hpp"
#include "contact/reference/pushes/winding.hpp"
#include "mesh/adjacency.hpp"

namespace weft::reference {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void count_depth(Inside& inside, double depth) {
  ++inside.count;
  inside.deepest = std::max(inside.deepest, depth);
}

std::vector<Box> boxes_of(std::span<const Vec3d> positions, const auto& features) {
  std::vector<Box> boxes;
  for (const auto& feature : features) boxes.push_back(box_of(positions, feature));
  return boxes;
}

bool contains(const auto& feature, std::uint32_t vertex) {
  return std::find(feature.begin(), feature.end(), vertex) != feature.end();
}

/// Each vertex of one against the triangles of the other. The radius of the search is the best so far.
void nearest_triangles(const Surfaces& points, const Surfaces& faces, bool one_mesh, double& least) {
  const BoxTree tree(boxes_of(faces.positions, faces.triangles));
  for (std::uint32_t v = 0; v < points.positions.size(); ++v) {
    const Vec3d p = points.positions[v];
    if (!finite(Box{p, p})) continue;
    tree.within({p, p}, least, [&](std::uint32_t t) {
      const mesh::Triangle& face = faces.triangles[t];
      if (one_mesh && contains(face, v)) return;
      least = std::min(least, closest_on_triangle(p, faces.positions[face[0]], faces.positions[face[1]],
                                                  faces.positions[face[2]])
                                  .distance);
    });
  }
}

void nearest_edges(const Surfaces& a, const Surfaces& b, bool one_mesh, double& least) {
  const std::vector<mesh::Edge> of_a = mesh::mesh_edges(a.triangles), of_b = mesh::mesh_edges(b.triangles);
  const BoxTree tree(boxes_of(b.positions, of_b));
  for (const mesh::Edge& edge : of_a) {
    const Box query = box_of(a.positions, edge);
    if (!finite(query)) continue;
    tree.within(query, least, [&](std::uint32_t j) {
      const mesh::Edge& other = of_b[j];
      if (one_mesh && (contains(other, edge[0]) || contains(other, edge[1]))) return;
      least = std::min(least, closest_segments(a.positions[edge[0]], a.positions[edge[1]],
                                               b.positions[other[0]], b.positions[other[1]])
                                  .distance);
    });
  }
}

}  // namespace

std::vector<Vec3d> widened(std::span<const Vec3f> positions) {
  std::vector<Vec3d> wide;
  for (const Vec3f& p : positions) wide.push_back(p.to<double>());
  return wide;
}

std::vector<Vec3d> rounded_to_f32(std::span<const Vec3d> positions) {
  std::vector<Vec3d> rounded;
  for (const Vec3d& p : positions) rounded.push_back(p.to<float>().to<double>());
  return rounded;
}

Box box_of(std::span<const Vec3d> positions, std::span<const std::uint32_t> vertices) {
  Box box{positions[vertices[0]], positions[vertices[0]]};
  for (const std::uint32_t vertex : vertices) {
    const Vec3d& p = positions[vertex];
    if (!finite(Box{p, p})) return {p, p};  // min and max would drop a NaN
    box = around(box, {p, p});
  }
  return box;
}

Inside inside_mesh(std::span<const Vec3d> positions, const mesh::TriangleMesh& mesh) {
  const std::vector<Vec3d> points = widened(mesh.positions);
  const std::vector<Box> boxes = boxes_of(points, mesh.triangles);
  const BoxTree tree(boxes);
  Inside inside;
  if (boxes.empty()) return inside;
  Box whole = boxes[0];
  for (const Box& box : boxes) whole = around(whole, box);
  for (const Vec3d& p : positions) {
    if (!overlap({p, p}, whole) || !reference::inside(p, mesh)) continue;
    double depth = kInfinite;
    tree.within({p, p}, depth, [&](std::uint32_t t) {
      const mesh::Triangle& face = mesh.triangles[t];
      depth =
          std::min(depth, closest_on_triangle(p, points[face[0]], points[face[1]], points[face[2]]).distance);
    });
    count_depth(inside, depth);
  }
  return inside;
}

Inside inside_capsule(std::span<const Vec3d> positions, const Vec3d& a, const Vec3d& b, double radius) {
  Inside inside;
  for (const Vec3d& p : positions)
    if (const double gap = closest_on_segment(p, a, b).distance - radius; gap < 0) count_depth(inside, -gap);
  return inside;
}

Inside below_plane(std::span<const Vec3d> positions, const scene::ColliderPlane& plane) {
  Inside inside;
  for (const Vec3d& p : positions)
    if (const double gap = plane_gap(p, plane.point, plane.normal).distance; gap < 0)
      count_depth(inside, -gap);
  return inside;
}

double least_distance(const Surfaces& cloth, const Surfaces& object) {
  double least = kInfinite;
  nearest_triangles(cloth, object, false, least);
  nearest_triangles(object, cloth, false, least);
  nearest_edges(cloth, object, false, least);
  return least;
}

double least_self_distance(const Surfaces& cloth) {
  double least = kInfinite;
  nearest_triangles(cloth, cloth, true, least);
  nearest_edges(cloth, cloth, true, least);
  return least;
}

}  // namespace weft::reference
