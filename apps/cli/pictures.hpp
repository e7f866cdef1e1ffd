#pragma once

#include <optional>
#include <string>

#include "picture/offscreen.hpp"
#include "picture/png_writer.hpp"
#include "picture/video_writer.hpp"
#include "sim/world.hpp"

namespace weft::cli {

/// The frames of a run as PNG files and, where ffmpeg is, as a video.
class Pictures {
 public:
  /// Errors  Shader, Limit, OutOfMemory.
  static Result<std::unique_ptr<Pictures>> create(sim::World& world);
  /// Writes into this folder from now on; the first picture is of this frame. Errors  Failure: it cannot be written.
  Result<void> begin(const std::string& folder, std::uint32_t frame);

  /// Draws the current state as the next frame; pictures are written as they arrive.
  Result<void> draw(const sim::World& world);
  /// From the next picture on.
  void set_camera(const render::Camera& camera) { offscreen_->set_camera(camera); }
  /// Gives up what is on its way, since the device is lost; nothing is drawn before go_on.
  void let_go() { offscreen_.reset(); }
  /// Goes on in another world of the same scene. Frames that have been written are not written again.
  Result<void> go_on(sim::World& world);
  /// Waits until all pictures are written.
  Result<void> settle();
  /// The same, and the video too: there are no more.
  Result<void> finish();
  std::uint32_t count() const { return stored_ - first_; }
  bool can_video() const { return video_.has_value(); }
  /// Whether there are frames to make a video of, and ffmpeg to make it.
  bool has_video() const { return can_video() && stored_ > first_; }

 private:
  Result<void> start_drawing(sim::World& world);
  Result<void> store(picture::Image image);

  std::string folder_;
  gpu::Device* device_ = nullptr;
  std::optional<picture::Offscreen> offscreen_;
  std::optional<picture::VideoWriter> video_;
  picture::PngWriter png_;
  gpu::CommandList list_;
  scene::Render render_;
  double frame_s_ = 0;  // from one picture to the next [s]
  std::uint32_t first_ = 0, next_ = 0,
                stored_ = 0;  // frames: the first, the next picture's, and where none is written
};

}  // namespace weft::cli
