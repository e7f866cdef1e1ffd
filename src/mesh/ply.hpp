// The Polygon File Format: text, binary of either byte order, gzipped.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_attributes.hpp"

namespace weft::mesh {

/// x, y and z of element vertex and the list vertex_indices (or vertex_index) of element face; other
/// properties and elements are passed over. Polygons become fans. Data that begin as gzip are unpacked first
/// (bounds: gzip.hpp). Errors  Input: what is wrong, with the line or byte. Source  Turk, The PLY Polygon
/// File Format, 1994.
Result<TriangleMesh> read_ply(std::span<const std::byte> bytes);

/// A binary little-endian PLY file that reads back to the same bits; nx, ny, nz and s, t follow a vertex's place where
/// there are such attributes. The mesh passes check_mesh; the comment, if any, is one line.
std::vector<std::byte> write_ply(const TriangleMesh& mesh, const std::string& comment = {},
                                 const VertexAttributes& attributes = {});

/// How a file of write_ply with this comment begins.
std::string ply_begin(const std::string& comment);

}  // namespace weft::mesh
