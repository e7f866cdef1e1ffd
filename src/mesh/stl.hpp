// Stereolithography files, text and binary.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// The triangles of an STL file; normals, colours and names are passed over. Corners with equal bits (-0 read
/// as 0) become one vertex, numbered in the order of their first appearance. A file whose size is 84 + 50 n
/// bytes for the n that it states is binary, any other is text. Errors  Input: what is wrong, with the line
/// or triangle. Source  3D Systems, StereoLithography Interface Specification, 1989.
Result<TriangleMesh> read_stl(std::span<const std::byte> bytes);

}  // namespace weft::mesh
