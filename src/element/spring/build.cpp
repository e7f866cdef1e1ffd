#include "element/spring/build.hpp"

namespace weft {
namespace {

ElementTable table_of(const std::vector<mesh::MeshSpring>& springs, const SpringMaterial& material,
                      std::uint32_t first) {
  ElementTable table{ElementKind::Spring, {}, {}, {}};
  table.nodes.reserve(2 * springs.size());
  table.rest.reserve(springs.size());
  table.material.reserve(2 * springs.size());
  for (const mesh::MeshSpring& spring : springs) {
    const double stiffness = spring.kind == mesh::SpringKind::Structural ? material.stiffness.structural
                             : spring.kind == mesh::SpringKind::Shear    ? material.stiffness.shear
                                                                         : material.stiffness.bend;
    append(table, Spring{first + spring.node_a, first + spring.node_b, static_cast<float>(spring.rest_length),
                         static_cast<float>(spring.weight * stiffness),
                         static_cast<float>(stiffness > 0 ? spring.weight * material.damping : 0)});
  }
  return table;
}

}  // namespace

ElementTable build_springs(const mesh::Grid& grid, const SpringMaterial& material, std::uint32_t first) {
  return table_of(mesh::grid_springs(grid, material.weights), material, first);
}

ElementTable build_springs(const mesh::TriangleMesh& mesh, const SpringMaterial& material,
                           std::uint32_t first) {
  return table_of(mesh::mesh_springs(mesh, material.weights), material, first);
}

ElementTable build_springs(const mesh::TriangleMesh& mesh, std::span<const mesh::Triangle> torn,
                           const SpringMaterial& material, std::uint32_t first) {
  return table_of(mesh::torn_springs(mesh, material.weights, torn), material, first);
}

ElementTable build_sewn_springs(const mesh::TriangleMesh& pattern, std::span<const mesh::Triangle> sewn,
                                const SpringMaterial& material, std::uint32_t first) {
  return table_of(mesh::sewn_springs(pattern, material.weights, sewn), material, first);
}

}  // namespace weft
