// Meshes of Gmsh.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// The nodes and the tetrahedra of four nodes (elements of type 4) of an MSH file of version 2.2 or 4.1, text or
/// little-endian; other elements, groups and fields are passed over. Node numbers may have gaps. The mesh passes
/// check_tets. Errors  Input: what is wrong, with the line or byte. Source  Gmsh reference manual, "MSH file format".
Result<TetMesh> read_msh(std::span<const std::byte> bytes);

}  // namespace weft::mesh
