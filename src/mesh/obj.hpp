// Wavefront OBJ.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_attributes.hpp"

namespace weft::mesh {

/// The vertices and faces of an OBJ text; all else in it (normals, textures, groups, lines) is passed over.
/// Polygons become fans. A positive index may name a vertex that comes later in the file; a negative one
/// counts back. Errors  Input: what is wrong, with the line. Source  Wavefront Advanced Visualizer manual,
/// appendix B1.
Result<TriangleMesh> read_obj(std::span<const std::byte> bytes);

/// An OBJ text of "v" and "f" lines, with "vt" and "vn" where there are such attributes, that reads back to the same
/// bits. The mesh passes check_mesh.
std::vector<std::byte> write_obj(const TriangleMesh& mesh, const VertexAttributes& attributes = {});

}  // namespace weft::mesh
