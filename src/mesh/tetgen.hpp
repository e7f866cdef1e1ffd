// Meshes of TetGen: tetrahedra in a file .ele, their nodes in a file .node.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// The mesh of two texts. Nodes are numbered from 0 or 1, as the first one says; of tetrahedra of ten nodes the four
/// corners are read. Attributes, markers and comments (from # on) are passed over. The mesh passes check_tets.
/// Errors  Input: what is wrong, with the file and its line. Source  Si, TetGen 1.5 user's manual, section 5.2.
Result<TetMesh> read_tetgen(std::span<const std::byte> ele, std::span<const std::byte> node);

}  // namespace weft::mesh
