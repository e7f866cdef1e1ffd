#include "picture/video_writer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace weft::picture {
namespace {

/// Whether this ffmpeg can encode one black frame as H.264.
bool has_libx264(const std::string& ffmpeg) {
  auto probe =
      ChildProcess::start({ffmpeg, "-nostdin", "-v", "error", "-f", "lavfi", "-i", "color=black:s=64x64",
                           "-frames:v", "1", "-c:v", "libx264", "-f", "null", "-"});
  return probe && probe->finish();
}

std::vector<std::string> arguments_of(const std::string& ffmpeg, std::uint32_t width, std::uint32_t height,
                                      double rate, const std::string& target) {
  char size[32], frames[32];
  std::snprintf(size, sizeof size, "%ux%u", width, height);
  std::snprintf(frames, sizeof frames, "%.10g", rate);
  std::vector<std::string> all = {ffmpeg,          "-v",   "error",       "-f", "rawvideo",
                                  "-pixel_format", "rgba", "-video_size", size, "-framerate",
                                  frames,          "-i",   "pipe:0"};
  // 4:2:0 needs even sides, so an odd one gets a black line. Without a word on it, players guess the colour
  // matrix.
  const std::vector<std::string> picture = {
      "-vf",
      "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
      "-colorspace",
      "bt709",
      "-color_primaries",
      "bt709",
      "-color_trc",
      "bt709",
      "-color_range",
      "tv"};
  const std::vector<std::string> h264 = {"-c:v", "libx264", "-preset", "veryfast", "-crf", "18"};
  const std::vector<std::string> mpeg4 = {"-c:v", "mpeg4", "-q:v", "3"};
  const std::vector<std::string> file = {"-movflags", "+faststart", "-f", "mp4", "-y", "file:" + target};
  for (const auto& part : {picture, has_libx264(ffmpeg) ? h264 : mpeg4, file})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

VideoWriter::VideoWriter(VideoWriter&& other) noexcept { *this = std::move(other); }
VideoWriter& VideoWriter::operator=(VideoWriter&& other) noexcept {
  std::swap(ffmpeg_, other.ffmpeg_);
  std::swap(path_, other.path_);
  std::swap(temporary_, other.temporary_);
  width_ = other.width_;
  height_ = other.height_;
  frame_count_ = other.frame_count_;
  return *this;
}
VideoWriter::~VideoWriter() { give_up(); }

Result<std::optional<VideoWriter>> VideoWriter::create(const std::string& path, std::uint32_t width,
                                                       std::uint32_t height, double frames_per_second) {
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg) return std::optional<VideoWriter>{};
  VideoWriter writer;
  writer.path_ = path;
  writer.width_ = width;
  writer.height_ = height;
  const std::string temporary = path + ".tmp" + std::to_string(::getpid());
  // Made here, so that a place that cannot be written is known before the first frame.
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0)
    return make_error(ErrorKind::Failure, "File %s cannot be written: %s.", path.c_str(),
                      std::strerror(errno));
  ::close(file);
  writer.temporary_ = temporary;
  WEFT_TRY(child, ChildProcess::start(arguments_of(*ffmpeg, width, height, frames_per_second, temporary)));
  writer.ffmpeg_ = std::move(child);
  return std::optional<VideoWriter>(std::move(writer));
}

Result<void> VideoWriter::add(const Image& image) {
  if (image.width != width_ || image.height != height_)
    return shape_error("A picture of %u x %u pixels is not of the video's %u x %u.", image.width,
                       image.height, width_, height_);
  const Result<void> written = ffmpeg_.write(std::as_bytes(std::span(image.rgba)));
  ++frame_count_;
  if (!written) give_up();
  return written;
}

Result<void> VideoWriter::finish() {
  if (frame_count_ == 0) {  // ffmpeg would call it a success
    give_up();
    return make_error(ErrorKind::Failure, "Video %s has no frames.", path_.c_str());
  }
  if (auto ended = ffmpeg_.finish(); !ended) {
    give_up();
    return ended.error().while_doing("writing " + path_);
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int reason = errno;
    give_up();
    return make_error(ErrorKind::Failure, "File %s cannot be replaced: %s.", path_.c_str(),
                      std::strerror(reason));
  }
  temporary_.clear();
  return {};
}

void VideoWriter::give_up() {
  if (temporary_.empty()) return;
  ffmpeg_ = ChildProcess();
  ::unlink(temporary_.c_str());
  temporary_.clear();
}

}  // namespace weft::picture
