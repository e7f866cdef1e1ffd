#include "mesh/simplify.hpp"

#include <meshoptimizer.h>

#include <limits>

namespace weft::mesh {

TriangleMesh without_unused_vertices(const TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(mesh.positions.size(), kUnused);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) new_index[vertex] = 0;
  TriangleMesh result;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (new_index[i] == kUnused) continue;
    new_index[i] = static_cast<std::uint32_t>(result.positions.size());
    result.positions.push_back(mesh.positions[i]);
  }
  result.triangles = mesh.triangles;
  for (Triangle& triangle : result.triangles)
    for (std::uint32_t& vertex : triangle) vertex = new_index[vertex];
  return result;
}

Result<TriangleMesh> simplify(const TriangleMesh& mesh, std::size_t target_triangles) {
  if (mesh.triangles.size() <= target_triangles) return without_unused_vertices(mesh);
  constexpr float kAnyError = 1.0F;  // of the mesh's extent: the number of triangles alone decides
  TriangleMesh result{mesh.positions, std::vector<Triangle>(mesh.triangles.size())};
  const std::size_t index_count = meshopt_simplify(
      result.triangles[0].data(), mesh.triangles[0].data(), 3 * mesh.triangles.size(), &mesh.positions[0].x,
      mesh.positions.size(), sizeof(Vec3f), 3 * target_triangles, kAnyError, 0, nullptr);
  result.triangles.resize(index_count / 3);
  if (result.triangles.size() > target_triangles || result.triangles.empty())
    return make_error(ErrorKind::Failure, "The mesh of %zu triangles simplifies to %zu, not to 1 to %zu.",
                      mesh.triangles.size(), result.triangles.size(), target_triangles);
  return without_unused_vertices(result);
}

}  // namespace weft::mesh
