// Files that were dropped on the window: which of them is what.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace weft::window {

enum class DroppedKind { Scene, Mesh, State };

struct Dropped {
  DroppedKind kind = DroppedKind::Mesh;
  std::string path;
};

/// The one file that is to be opened: by the end of its name a scene (.json), a saved state (.weft) or else a mesh. A
/// scene finds its meshes beside it, so those that come with it need not be opened.
/// Errors  Input: no file; two scenes; more than one mesh or state.
Result<Dropped> dropped_file(const std::vector<std::string>& paths);

}  // namespace weft::window
