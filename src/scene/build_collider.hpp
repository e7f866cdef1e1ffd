#pragma once

#include <string>

#include "base/json.hpp"
#include "base/result.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// The collider that stands at `path` of a file, and that check() has passed.
/// Errors  Input: the contact method cannot do what it asks for; times of a path or of keyframes do not rise;
///         a capsule has no length.
Result<Collider> build_collider(const Json& json, ContactMethod method, const std::string& file,
                                const std::string& path);

}  // namespace weft::scene
