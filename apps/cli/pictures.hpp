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
  /// Writes into this folder from now on. Errors  Failure: it cannot be written.
  Result<void> begin(const std::string& folder);

  /// Draws the current state as the next frame; pictures are written as they arrive.
  Result<void> draw(const sim::World& world);
  /// Waits until all is written.
  Result<void> finish();
  std::uint32_t count() const { return drawn_; }
  bool can_video() const { return video_.has_value(); }
  /// Whether there are frames to make a video of, and ffmpeg to make it.
  bool has_video() const { return can_video() && drawn_ > 0; }

 private:
  Result<void> store(picture::Image image);

  std::string folder_;
  gpu::Device* device_ = nullptr;
  std::optional<picture::Offscreen> offscreen_;
  std::optional<picture::VideoWriter> video_;
  picture::PngWriter png_;
  gpu::CommandList list_;
  scene::Render render_;
  double frame_s_ = 0;  // from one picture to the next [s]
  std::uint32_t drawn_ = 0, stored_ = 0;
};

}  // namespace weft::cli
