// Point caches: the places of all vertices at each time, beside an OBJ file of the first mesh that they move.
#pragma once

#include "export/exporter.hpp"

namespace weft {

/// PC2, little-endian: "POINTCACHE2" and a 0, version 1, points (i32), first frame, frames from one mesh to the next
/// (f32), meshes (i32); then three f32 for each point. Errors  Input: meshes at unequal distances.
Result<std::unique_ptr<Exporter>> make_pc2_exporter(const std::string& path, const RunMeshes& meshes);

/// MDD, big-endian: meshes, points (i32), the time of each mesh [s] (f32); then three f32 for each point.
Result<std::unique_ptr<Exporter>> make_mdd_exporter(const std::string& path, const RunMeshes& meshes);

}  // namespace weft
