#pragma once

#include <map>

#include "mesh/triangle_mesh.hpp"
#include "session/session.hpp"
#include "weft/scene.hpp"

namespace weft {

/// What a Scene holds.
struct [[gnu::visibility("hidden")]] Scene::Content {
  SceneText source;
  std::string models_folder;
  std::map<std::string, mesh::TriangleMesh> meshes;

  /// Reads the scene and its meshes: those that were added, all others from files. Errors  Input.
  Result<Inputs> read(const SceneText& changed) const;
};

}  // namespace weft
