#pragma once

#include <string>

#include "base/json.hpp"
#include "base/result.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// The motion of nodes or of a collider that stands at `path` of a file, and that check() has passed.
/// Errors  Input: the times of a path do not rise.
Result<MotionShape> build_motion(const Json& json, const std::string& file, const std::string& path);

}  // namespace weft::scene
