#pragma once

#include <optional>

#include "picture/offscreen.hpp"
#include "session/session.hpp"
#include "weft/world.hpp"

namespace weft {

/// What a World holds.
struct RunningWorld {
  /// What draws pictures of one size and view.
  struct Drawing {
    std::uint32_t width = 0, height = 0;
    View view = View::Textured;
    bool legend = true;
    picture::Offscreen offscreen;
  };

  Session session;
  // They draw from the session's buffers: they go before it.
  std::optional<Drawing> drawing;
  std::optional<view::CanvasView> texture_view;

  /// Opens the device and loads the scene. Errors  as World::create and World::create_on.
  static Result<std::unique_ptr<RunningWorld>> create(gpu::DeviceOptions device, const SceneText& source,
                                                      const ReadInputs& read);

  sim::World& world() { return *session.world(); }
  /// Sews and tears what is due, and simulates a frame. Errors  as World::advance.
  Result<void> advance();
  /// Does what may make the world anew: what drew the old one goes.
  Result<void> reset();
  Result<std::string> open_state(std::span<const std::byte> bytes);
  Result<std::vector<std::byte>> save_state();
  /// Waits for all frames. A diverged world has its last good state to show, so that is no error here.
  Result<void> settle();
  /// How a picture is drawn, with the scene's own wishes where there is no option; the camera is the scene's, which
  /// the light comes with. Errors  Input: a side is 0.
  Result<render::Settings> settings(const PictureOptions& options);
  /// Forgets what draws a world that is no more.
  void let_go();
  /// Counts contacts for as long as anything that is drawn shows them. Errors  Shader.
  Result<void> count_contacts();
  /// The buffer that holds a quantity of the state at the end of the last frame.
  const gpu::RawBuffer& buffer(Buffer::Quantity quantity);
};

}  // namespace weft
