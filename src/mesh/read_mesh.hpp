// A mesh from a file of any format that weft knows.
#pragma once

#include <string>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Reads .obj, .off, .stl, .ply or .ply.gz, by the name's end in capitals or not; whether it is text or
/// binary shows from the content. The mesh passes check_mesh. Errors  Input: "While reading mesh PATH: ...",
/// also for a file that is missing or over kMaxMeshBytes.
Result<TriangleMesh> read_mesh(const std::string& path);

}  // namespace weft::mesh
