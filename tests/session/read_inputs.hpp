// How a session's tests read a scene: with the meshes of files.
#pragma once

#include <string>
#include <utility>

#include "scene/load.hpp"
#include "session/session.hpp"

namespace weft {

inline Result<Inputs> read_inputs(const SceneText& source) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  WEFT_TRY(assets, load_assets(scene, std::string()));
  return Inputs{std::move(scene), std::move(assets)};
}

}  // namespace weft
