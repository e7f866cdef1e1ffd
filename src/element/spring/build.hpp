#pragma once

#include <optional>
#include <span>

#include "element/spring/spring.hpp"
#include "mesh/springs.hpp"
#include "scene/scene.hpp"

namespace weft {

/// The parameters of a cloth's springs.
struct SpringMaterial {
  scene::Stiffness stiffness;  // [N/m]
  double damping = 0;          // [N·s/m]; a spring without stiffness has none
  mesh::BoundaryWeights weights = mesh::BoundaryWeights::Area;
  std::optional<double> strain_limit;  // beyond which structural springs are stiffer, of their length
};

/// The springs of a grid or a mesh, in the order of mesh/springs.hpp. Nodes are numbered from `first`.
ElementTable build_springs(const mesh::Grid& grid, const SpringMaterial& material, std::uint32_t first);
ElementTable build_springs(const mesh::TriangleMesh& mesh, const SpringMaterial& material,
                           std::uint32_t first);
/// Those of a mesh that has torn: mesh::torn_springs.
ElementTable build_springs(const mesh::TriangleMesh& mesh, std::span<const mesh::Triangle> torn,
                           const SpringMaterial& material, std::uint32_t first);

/// Those of a mesh that is sewn: mesh::sewn_springs.
ElementTable build_sewn_springs(const mesh::TriangleMesh& pattern, std::span<const mesh::Triangle> sewn,
                                const SpringMaterial& material, std::uint32_t first);

}  // namespace weft
