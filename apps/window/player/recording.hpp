#pragma once

#include <memory>
#include <string>

#include "pictures.hpp"

namespace weft::window {

/// Pictures and a video of what is simulated while it lasts, as `weft run --out` writes them.
class Recording {
 public:
  /// Into this folder, by this view. Errors  Failure: it cannot be written. Shader, OutOfMemory.
  static Result<Recording> begin(sim::World& world, scene::View view, const std::string& folder);
  /// Draws the state as the next picture, from this camera. Waits for the frame: one that is repeated would be drawn as
  /// it was before. Errors  Failure: it cannot be written. DeviceLost.
  Result<void> add(sim::World& world, const render::Camera& camera);
  /// Goes on with a world that was made in the place of the one before. Errors  Shader, OutOfMemory.
  Result<void> go_on(sim::World& world) { return pictures_->go_on(world); }
  /// Where all is; the sentence says so. Errors  Failure: the disk is full.
  Result<std::string> end();

  std::uint32_t count() const { return pictures_->count(); }

 private:
  std::unique_ptr<cli::Pictures> pictures_;
  std::string folder_;
};

}  // namespace weft::window
