#pragma once

#include "export/exporter.hpp"

namespace weft {

/// A folder of a file for each mesh, by the number of its frame, and meshes.json: it can be exported in its turn.
/// Errors  Failure: the folder is there already.
Result<std::unique_ptr<Exporter>> make_obj_exporter(const std::string& path, const RunMeshes& meshes);
Result<std::unique_ptr<Exporter>> make_ply_exporter(const std::string& path, const RunMeshes& meshes);

}  // namespace weft
