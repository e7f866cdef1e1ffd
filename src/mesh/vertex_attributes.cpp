#include "mesh/vertex_attributes.hpp"

namespace weft::mesh {

std::vector<Vec3f> smooth_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].to<double>();
    const Vec3d normal = cross(mesh.positions[t[1]].to<double>() - a, mesh.positions[t[2]].to<double>() - a);
    for (const std::uint32_t vertex : t) sums[vertex] += normal;
  }
  std::vector<Vec3f> normals;
  normals.reserve(sums.size());
  for (const Vec3d& sum : sums) {
    const double size = length(sum);
    normals.push_back(size > 0.0 ? (sum / size).to<float>() : Vec3f{0, 1, 0});
  }
  return normals;
}

}  // namespace weft::mesh
