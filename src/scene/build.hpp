// Turns a checked JSON value into a Scene.
#pragma once

#include <string>

#include "base/json.hpp"
#include "base/result.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// The scene in `json`, which check() has passed and completed.
/// Errors  Input: what the table of keys cannot say: path times that do not rise, a box whose max is below
///         min, a grid's part on a mesh, colliders that the contact method does not know
///         (build_collider.hpp), a camera that looks at itself, over kMaxGridNodes grid nodes.
Result<Scene> build_scene(const Json& json, const std::string& file);

inline constexpr std::size_t kMaxGridNodes = std::size_t{1} << 26U;  // of all grids together

}  // namespace weft::scene
