#pragma once

#include "export/exporter.hpp"

namespace weft {

/// To standard output, for the Python package, which writes formats that only Python has libraries for. A line with
/// the size of the JSON that follows: `meshes` (as in meshes.json), `frames` (their numbers),
/// `vertices`, `triangles`, `texture` (whether there is any). Then, little-endian and without gaps, the triangles (u32)
/// and texture coordinates (f32) of the first mesh, and of each mesh its places and its normals (f32).
Result<std::unique_ptr<Exporter>> make_stream_exporter(const RunMeshes& meshes);

}  // namespace weft
