#pragma once

#include <cstdint>

#include "model/assets.hpp"
#include "scene/scene.hpp"

namespace weft::sim {

/// A hash of all that a scene's motion follows from: its content (scene::content_hash) and its meshes.
std::uint64_t scene_hash(const scene::Scene& scene, const Assets& assets);

}  // namespace weft::sim
