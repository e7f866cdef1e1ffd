// A tetrahedral mesh from a file of any format that weft knows.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace weft::mesh {

/// Reads .msh, .vtk, or .ele with the .node beside it, by the name's end in capitals or not; whether it is text or
/// binary shows from the content. The mesh passes check_tets. Errors  Input: "While reading mesh PATH: ...", also for a
/// file that is missing or over kMaxMeshBytes.
Result<TetMesh> read_tet_mesh(const std::string& path);

/// The same from a file's bytes; `name` only says which format they are in. `nodes` are those of the file that
/// nodes_beside names.
Result<TetMesh> read_tet_mesh(std::span<const std::byte> bytes, const std::string& name,
                              std::span<const std::byte> nodes = {});

/// Whether a name ends as that of a tetrahedral mesh, or of the nodes beside one.
bool names_tet_mesh(const std::string& name);

/// The name of the file that a mesh file needs beside it: for a.ele it is a.node, for other formats empty.
std::string nodes_beside(const std::string& name);

}  // namespace weft::mesh
