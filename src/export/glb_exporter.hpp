#pragma once

#include "export/exporter.hpp"

namespace weft {

/// A GLB file whose morph targets are the later meshes (mesh/glb_animation.hpp). Errors  Limit: over kMostGlbBytes.
Result<std::unique_ptr<Exporter>> make_glb_exporter(const std::string& path, const RunMeshes& meshes);

}  // namespace weft
