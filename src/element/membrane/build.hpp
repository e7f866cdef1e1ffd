// Membranes as rows of a table: three nodes; rest: the slopes of the second and third corner's shape functions along
// warp and weft [1/m]; material: C11, C12, C22, C33 [N/m] and τ [s].
#pragma once

#include <cstdint>
#include <span>

#include "element/membrane/law.hpp"
#include "element/table.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::membrane {

/// A sheet at rest: places [m], triangles that have areas, and the direction of warp, which triangles see projected.
struct Sheet {
  std::span<const Vec3d> position;
  std::span<const mesh::Triangle> triangles;
  Vec3d warp{1, 0, 0};
};

/// A membrane for each triangle, in their order. Nodes are numbered from `first`.
ElementTable build_membranes(const Sheet& sheet, const Law& law, std::uint32_t first);

/// A row of the table. What the table does not have follows: slopes sum to zero, and the area from their determinant.
Rest rest_of(const ElementTable& table, std::size_t element);

}  // namespace weft::membrane
