// The meshes that a scene of the command line names.
#pragma once

#include "base/result.hpp"
#include "model/assets.hpp"

namespace weft::cli {

/// Those in the scene's folder and among the models. Says on stderr what of them is left out or made one.
/// Errors  those of load_assets; Limit: more than the host's memory.
Result<Assets> load_checked_assets(const scene::Scene& scene);
/// The same where one mesh is not a file but given: the scene calls it `name`.
Result<Assets> load_checked_assets(const scene::Scene& scene, const std::string& name,
                                   const mesh::TriangleMesh& mesh);

}  // namespace weft::cli
