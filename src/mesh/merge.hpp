// Vertices that formats write more than once, and those that nothing names.
#pragma once

#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Makes one vertex of those with equal bits (-0 counts as 0, and the first one's bits stay), numbered in the
/// order of their first appearance. For formats that repeat a vertex: STL for each triangle, glTF where
/// normals or texture coordinates differ. The triangles name vertices that are there.
void merge_vertices(TriangleMesh& mesh);

/// Removes the vertices that no triangle names, and returns their number.
std::size_t drop_unused_vertices(TriangleMesh& mesh);

}  // namespace weft::mesh
