#include "render/object_mesh.hpp"

#include <algorithm>

#include "mesh/primitives.hpp"

namespace weft::render {
namespace {

constexpr int kSphereColumns = 96, kSphereRows = 48;

void append(const mesh::TriangleMesh& mesh, ObjectMesh& all) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  for (const Vec3f& position : mesh.positions) all.positions.push_back(Vec4f::from(position, 1));
  for (const Vec3f& normal : vertex_normals(mesh)) all.normals.push_back(Vec4f::from(normal, 0));
  for (const mesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) all.indices.push_back(first + vertex);
}

}  // namespace

std::vector<Vec3f> vertex_normals(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d pa = mesh.positions[a].to<double>();
    const Vec3d n = cross(mesh.positions[b].to<double>() - pa, mesh.positions[c].to<double>() - pa);
    for (const std::uint32_t vertex : {a, b, c}) sums[vertex] += n;
  }
  std::vector<Vec3f> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double size = length(sums[i]);
    normals[i] = size > 0 ? (sums[i] / size).to<float>() : Vec3f{0, 1, 0};
  }
  return normals;
}

bool is_closed(const mesh::TriangleMesh& mesh) {
  std::vector<std::uint64_t> there, back;
  for (const mesh::Triangle& triangle : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = triangle[i], b = triangle[(i + 1) % 3];
      there.push_back((a << 32U) | b);
      back.push_back((b << 32U) | a);
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  const bool each_once = std::adjacent_find(there.begin(), there.end()) == there.end();
  return each_once && there == back && mesh::signed_volume(mesh) > 0;
}

ObjectMesh join_objects(const Inputs& inputs) {
  ObjectMesh all;
  if (!inputs.spheres.empty()) {
    const mesh::TriangleMesh unit = mesh::make_sphere(kSphereColumns, kSphereRows);
    for (const scene::ColliderSphere& sphere : inputs.spheres) {
      mesh::TriangleMesh placed = unit;
      for (Vec3f& p : placed.positions) p = (sphere.center + sphere.radius * p.to<double>()).to<float>();
      append(placed, all);
    }
  }
  std::vector<const mesh::TriangleMesh*> open;
  for (const mesh::TriangleMesh& mesh : inputs.objects) {
    if (is_closed(mesh))
      append(mesh, all);
    else
      open.push_back(&mesh);
  }
  all.closed_index_count = all.indices.size();
  for (const mesh::TriangleMesh* mesh : open) append(*mesh, all);
  return all;
}

}  // namespace weft::render
