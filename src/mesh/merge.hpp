// Vertices that formats write more than once, and those that nothing names.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Makes one vertex of those with equal bits (-0 counts as 0, and the first one's bits stay), numbered in the
/// order of their first appearance, and returns how many went. For formats that repeat a vertex: STL for each triangle,
/// glTF where normals or texture coordinates differ. The triangles name vertices that are there. `shapes` are the
/// mesh's vertices in other places, as many: vertices become one where they are in every shape.
std::size_t merge_vertices(TriangleMesh& mesh, std::span<std::vector<Vec3f>> shapes = {});

/// Removes the vertices that no triangle names, and returns their number.
std::size_t drop_unused_vertices(TriangleMesh& mesh);

}  // namespace weft::mesh
