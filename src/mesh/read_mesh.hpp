// A mesh from a file of any format that weft knows.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/result.hpp"
#include "mesh/animated_mesh.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Reads .glb, .obj, .off, .stl, .ply or .ply.gz, by the name's end in capitals or not; whether it is text or
/// binary shows from the content. The mesh passes check_mesh. Errors  Input: "While reading mesh PATH: ...",
/// also for a file that is missing or over kMaxMeshBytes.
Result<TriangleMesh> read_mesh(const std::string& path);

/// The same from a file's bytes; `name` only says which format they are in.
Result<TriangleMesh> read_mesh(std::span<const std::byte> bytes, const std::string& name);

/// What a file animates (animated_mesh.hpp). Errors  Input: "While reading mesh PATH: ...", also for a file that is no
/// GLB.
Result<AnimatedMesh> read_animated_mesh(const std::string& path);
Result<AnimatedMesh> read_animated_mesh(std::span<const std::byte> bytes, const std::string& name);

}  // namespace weft::mesh
