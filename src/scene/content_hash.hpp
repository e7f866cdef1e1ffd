#pragma once

#include <cstdint>

#include "base/json.hpp"

namespace weft::scene {

/// A hash of all in a scene's JSON, defaults included, that its motion follows from, whatever the order of its keys:
/// not of its title, description, format, camera, render and time.frames, nor of the names and colours of cloths.
/// Meshes count by their names.
std::uint64_t content_hash(const Json& scene);

}  // namespace weft::scene
