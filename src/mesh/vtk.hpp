// Legacy files of the Visualization Toolkit.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// The points and the tetrahedra (cells of type 10) of an unstructured grid, text or big-endian, with cells as before
/// version 5 (rows that begin with their length) or as since (offsets and connectivity). Other cells, fields and what
/// comes after the cells are passed over. The mesh passes check_tets. Errors  Input: what is wrong, with the line or
/// byte. Source  VTK User's Guide, "Legacy file formats"; VTK 9.0 for version 5.1.
Result<TetMesh> read_vtk(std::span<const std::byte> bytes);

}  // namespace weft::mesh
