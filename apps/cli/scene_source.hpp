// Where a scene of the command line comes from: a shipped one, a file, or standard input.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"

namespace weft::cli {

/// The path of a program of this name in the folder of this one.
std::string beside_program(const std::string& name);
/// The folder of this name beside that of this program: "models", "scenes".
std::string folder_beside_program(const std::string& name);

/// The names of the shipped scenes, sorted; none where their folder is not beside the program's.
std::vector<std::string> shipped_scenes();

/// What SCENE means, before any of it is checked.
struct SceneSource {
  std::string text;  // JSON
  std::string file;  // what messages call it, and where relative mesh paths start
};

/// Errors  Input: there is no shipped scene of this name; the file or standard input cannot be read.
Result<SceneSource> find_scene(const std::string& source);

/// The scene that SCENE means: of letters, digits, _ and - a shipped one by its name, "-" standard input, where
/// relative mesh paths start at the current folder, and a path else.
/// Errors  Input: there is no shipped scene of this name; the file or standard input cannot be read; those of
///         scene::parse_scene.
Result<scene::Scene> read_scene(const std::string& source, std::span<const scene::Override> overrides);

}  // namespace weft::cli
