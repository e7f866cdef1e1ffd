#pragma once

#include <optional>
#include <string>

#include "out_folder.hpp"
#include "picture/offscreen.hpp"
#include "picture/png_writer.hpp"
#include "picture/video_writer.hpp"
#include "sim/world.hpp"

namespace weft::cli {

/// The frames of a run as PNG files and, where ffmpeg is, as a video.
class Pictures {
 public:
  /// Takes the folder, unless something is refused.
  /// Errors  Shader, Limit, OutOfMemory; Failure where the folder cannot be written or is in use.
  static Result<std::unique_ptr<Pictures>> create(sim::World& world, const std::string& folder);

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

  std::optional<OutFolder> folder_;  // given back last
  gpu::Device* device_ = nullptr;
  std::optional<picture::Offscreen> offscreen_;
  std::optional<picture::VideoWriter> video_;
  picture::PngWriter png_;
  gpu::CommandList list_;
  std::uint32_t drawn_ = 0, stored_ = 0;
};

}  // namespace weft::cli
