#pragma once

#include "player/commands.hpp"

namespace weft::window {

/// Asks what a mesh that was dropped is to be, while there is such a question. Errors  those of Commands::answer.
Result<void> draw_mesh_dialog(Commands& commands);

}  // namespace weft::window
