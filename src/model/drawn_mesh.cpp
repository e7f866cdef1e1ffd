#include "model/drawn_mesh.hpp"

#include <cassert>

#include "mesh/subdivided_grid.hpp"

namespace weft {

mesh::TriangleMesh drawn_mesh(const Model& model, std::span<const Vec4f> positions, std::uint32_t level) {
  mesh::TriangleMesh drawn;
  if (level == 0) {
    for (const Vec4f& position : positions) drawn.positions.push_back(position.xyz());
    drawn.triangles = model.triangles;
    return drawn;
  }
  for (const Body& body : model.bodies) {
    assert(body.grid);
    std::vector<Vec3d> nodes;
    for (const Vec4f& position : positions.subspan(body.first_vertex, body.vertex_count))
      nodes.push_back(position.xyz().to<double>());
    const auto first = static_cast<std::uint32_t>(drawn.positions.size());
    for (const Vec3d& vertex : mesh::upsample(*body.grid, nodes, level))
      drawn.positions.push_back(vertex.to<float>());
    for (const mesh::Triangle& t : mesh::grid_triangles(mesh::subdivided(*body.grid, level)))
      drawn.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return drawn;
}

}  // namespace weft
