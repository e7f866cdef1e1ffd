#include "mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace weft::mesh {
namespace {

bool has_area(const std::vector<Vec3f>& positions, const Triangle& t) {
  const Vec3d a = positions[t[0]].to<double>();
  return !(cross(positions[t[1]].to<double>() - a, positions[t[2]].to<double>() - a) == Vec3d{});
}

bool is_degenerate(const TriangleMesh& mesh, std::span<const std::vector<Vec3f>> shapes, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
  return !has_area(mesh.positions, t) &&
         std::none_of(shapes.begin(), shapes.end(),
                      [&](const std::vector<Vec3f>& shape) { return has_area(shape, t); });
}

// A double beyond float's range is undefined to convert, so it is infinite by hand.
float rounded(double value) {
  if (std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))
    return static_cast<float>(value);
  return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(std::copysign(1.0, value)));
}

}  // namespace

Bounds bounds(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds box{mesh.positions[0], mesh.positions[0]};
  for (const Vec3f& p : mesh.positions) {
    box.low = min(box.low, p);
    box.high = max(box.high, p);
  }
  return box;
}

double signed_volume(const TriangleMesh& mesh) {
  std::vector<Vec3d> places;
  for (const Vec3f& p : mesh.positions) places.push_back(p.to<double>());
  return signed_volume(mesh.triangles, places);
}

double signed_volume(std::span<const Triangle> triangles, std::span<const Vec3d> places) {
  if (triangles.empty()) return 0;
  const Vec3d from = places[triangles[0][0]];
  double six_volumes = 0.0;  // of the tetrahedra between each triangle and `from`
  for (const auto& [a, b, c] : triangles)
    six_volumes += dot(places[a] - from, cross(places[b] - from, places[c] - from));
  return six_volumes / 6.0;
}

Result<void> check_mesh(const TriangleMesh& mesh) {
  constexpr std::size_t kMaxCount = std::numeric_limits<std::uint32_t>::max();
  if (mesh.triangles.empty()) return input_error("The mesh has no triangles.");
  if (mesh.positions.size() > kMaxCount || mesh.triangles.size() > kMaxCount)
    return input_error("The mesh has %zu vertices and %zu triangles, more than the limit of %zu.",
                       mesh.positions.size(), mesh.triangles.size(), kMaxCount);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (const float value = mesh.positions[i][axis]; !std::isfinite(value))
        return input_error("Vertex %zu has the coordinate %g, which is not finite.", i,
                           static_cast<double>(value));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t vertex : mesh.triangles[i])
      if (vertex >= mesh.positions.size())
        return input_error("Triangle %zu names vertex %u, but the mesh has only %zu vertices.", i, vertex,
                           mesh.positions.size());
  return {};
}

std::size_t drop_degenerate_triangles(TriangleMesh& mesh, std::span<const std::vector<Vec3f>> shapes) {
  const std::size_t before = mesh.triangles.size();
  const auto end = std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
                                  [&](const Triangle& t) { return is_degenerate(mesh, shapes, t); });
  mesh.triangles.erase(end, mesh.triangles.end());
  return before - mesh.triangles.size();
}

TriangleMesh transformed(const TriangleMesh& mesh, double scale, const Quaternion& rotation,
                         const Vec3d& translation) {
  assert(scale > 0.0);  // a negative one would turn the mesh inside out
  const Vec3d axis{rotation[0], rotation[1], rotation[2]};
  const double w = rotation[3];
  const double norm = dot(axis, axis) + w * w;
  assert(norm > 0.0);
  TriangleMesh result = mesh;
  for (Vec3f& p : result.positions) {
    const Vec3d v = scale * p.to<double>();
    const Vec3d turn = (2.0 / norm) * cross(axis, v);
    const Vec3d moved = v + w * turn + cross(axis, turn) + translation;  // q v q⁻¹, multiplied out
    p = {rounded(moved.x), rounded(moved.y), rounded(moved.z)};
  }
  return result;
}

}  // namespace weft::mesh
