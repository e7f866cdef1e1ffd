#pragma once

#include <optional>

#include "picture/offscreen.hpp"
#include "session/session.hpp"

namespace weft {

/// What a World holds.
struct RunningWorld {
  /// What draws pictures of one size and view.
  struct Drawing {
    std::uint32_t width = 0, height = 0;
    View view = View::Textured;
    bool legend = true;
    picture::Offscreen offscreen;
    Camera first_camera;
  };

  Session session;
  std::optional<Drawing> drawing;  // draws from the session's buffers: goes before it

  sim::World& world() { return *session.world(); }
  /// Waits for all frames. A diverged world has its last good state to show, so that is no error here.
  Result<void> settle();
};

}  // namespace weft
