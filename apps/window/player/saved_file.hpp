// Files that the window saves.
#pragma once

#include <string>

#include "player/player.hpp"

namespace weft::window {

/// What is on a texture. Errors  OutOfMemory, DeviceLost.
Result<picture::Image> image_of(gpu::Device& device, const gpu::Texture& texture);

/// Writes the picture ("png"), the shape ("obj", "ply", "glb") or the state ("weft") into the folder, by a name as
/// hanging-00120.glb; its path. Errors  Failure: it cannot be written. DeviceLost.
Result<std::string> save_file(Player& player, const std::string& folder, const std::string& end);

}  // namespace weft::window
