// Reads scenes. docs/scene.md is the reference of the format.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// The scene in a JSON text, with `overrides` applied in order before the checks.
/// Reads   text: UTF-8, at most 16 MiB; file: what messages call it, and where relative mesh paths start.
/// Errors  Input: not JSON, or not a scene; file, JSON path, value and limit are in the message.
Result<Scene> parse_scene(std::string_view text, const std::string& file,
                          std::span<const Override> overrides = {});

/// The scene in a file. Errors as parse_scene; Input too where the file cannot be read.
Result<Scene> load_scene(const std::string& path, std::span<const Override> overrides = {});

/// Where the mesh called `mesh` is: a name of letters, digits, _ and - is models_folder/NAME.ply, all else a
/// path relative to the folder of the scene's file.
///
/// Errors  Input: a model that has not been made; a path with a control character.
Result<std::string> mesh_path(const Scene& scene, const std::string& mesh, const std::string& models_folder);

}  // namespace weft::scene
