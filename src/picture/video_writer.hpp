#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "picture/child_process.hpp"
#include "picture/image.hpp"

namespace weft::picture {

/// An MP4 file, encoded by the ffmpeg program: H.264 where it has libx264, else MPEG-4 part 2; yuv420p,
/// BT.709, ready to stream. The file appears when finish succeeds; before that, and after any error, there is
/// none.
class VideoWriter {
 public:
  VideoWriter() = default;
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();  ///< without finish, the video is given up

  /// Nothing where there is no ffmpeg on PATH.
  /// Errors  Failure: the place cannot be written, or ffmpeg cannot be started.
  static Result<std::optional<VideoWriter>> create(const std::string& path, std::uint32_t width,
                                                   std::uint32_t height, double frames_per_second = 60);

  /// Errors  Shape: the picture has another size. Failure: ffmpeg has ended, with what it said.
  Result<void> add(const Image& image);
  /// Errors  Failure: there was no frame, ffmpeg failed, with what it said, or the file cannot be renamed.
  Result<void> finish();

 private:
  void give_up();

  ChildProcess ffmpeg_;
  std::string path_, temporary_;  // `temporary_` is empty when there is nothing to remove
  std::uint32_t width_ = 0, height_ = 0, frame_count_ = 0;
};

}  // namespace weft::picture
