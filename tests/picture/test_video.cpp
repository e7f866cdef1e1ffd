#include <doctest/doctest.h>

#include <signal.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>

#include "base/random.hpp"
#include "picture/video_writer.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using namespace weft::picture;

namespace {

Image colored(std::uint32_t width, std::uint32_t height, std::uint8_t red) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 255)};
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) image.rgba[i] = red;
  return image;
}

/// The output of a program.
std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[256];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) text += buffer;
  ::pclose(pipe);
  return text;
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// PATH with another value while it lives.
class PathIs {
 public:
  explicit PathIs(const std::string& value) : before_(::getenv("PATH")) {
    ::setenv("PATH", value.c_str(), 1);
  }
  ~PathIs() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("a video has the frames, the size and the rate that were given, and appears at the end") {
  if (!find_program("ffmpeg")) return;
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair{320U, 180U}, {151U, 75U}}) {  // odd sides are padded
    const std::string path = folder.path("run " + std::to_string(width) + ".mp4");
    auto writer = VideoWriter::create(path, width, height, 30);
    REQUIRE(writer);
    REQUIRE(*writer);
    for (int i = 0; i < 24; ++i)
      REQUIRE((*writer)->add(colored(width, height, static_cast<std::uint8_t>(10 * i))));
    CHECK_FALSE(std::filesystem::exists(path));
    const auto finished = (*writer)->finish();
    REQUIRE_MESSAGE(finished, finished.error().message);
    const std::string probe = output_of(
        "ffprobe -v error -count_frames -select_streams v:0 -of csv=p=0 -show_entries "
        "stream=width,height,pix_fmt,r_frame_rate,nb_read_frames '" +
        path + "'");
    char expected[80];
    std::snprintf(expected, sizeof expected, "%u,%u,yuv420p,30/1,24\n", (width + 1) / 2 * 2,
                  (height + 1) / 2 * 2);
    CHECK(probe == expected);
    const std::string head =
        output_of("head -c 4096 '" + path + "' | tr -d '\\0' | grep -ao 'moov' | head -1");
    CHECK(head == "moov\n");  // ready to stream: the index stands at the front
  }
  CHECK(files_in(folder.path("")) == 2);
}

TEST_CASE("a video that cannot be written is an error, and nothing is left behind") {
  if (!find_program("ffmpeg")) return;
  const auto nowhere = VideoWriter::create("/nowhere/run.mp4", 64, 64);
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.error().message.find("/nowhere/run.mp4") != std::string::npos);
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("run.mp4"));  // a folder is in the way of the rename
  auto writer = VideoWriter::create(folder.path("run.mp4"), 64, 64);
  REQUIRE(writer);
  REQUIRE((*writer)->add(colored(64, 64, 1)));
  CHECK_FALSE((*writer)->finish());
  CHECK(files_in(folder.path("")) == 1);
  CHECK(files_in(folder.path("run.mp4")) == 0);
}

TEST_CASE("a video without frames, and one that is given up, leave nothing") {
  if (!find_program("ffmpeg")) return;
  const TemporaryFolder folder;
  auto empty = VideoWriter::create(folder.path("empty.mp4"), 64, 64);
  REQUIRE(empty);
  const auto finished = (*empty)->finish();
  CHECK_FALSE(finished);
  {
    auto given_up = VideoWriter::create(folder.path("up.mp4"), 64, 64);
    REQUIRE(given_up);
    REQUIRE((*given_up)->add(colored(64, 64, 1)));
    CHECK((*given_up)->add(colored(64, 65, 1)).error().kind == ErrorKind::Shape);
  }
  CHECK(files_in(folder.path("")) == 0);
}

TEST_CASE("without ffmpeg there is no video and no error") {
  const PathIs nowhere("/nowhere");
  const auto writer = VideoWriter::create("/tmp/none.mp4", 64, 64);
  REQUIRE(writer);
  CHECK_FALSE(*writer);
}

TEST_CASE("an encoder that dies is an error with its words, and not our end") {
  const TemporaryFolder folder;
  const std::string script = folder.path("ffmpeg");
  {
    std::FILE* file = std::fopen(script.c_str(), "w");
    std::fputs("#!/bin/sh\necho 'The disk is on fire.' >&2\nexit 3\n", file);
    std::fclose(file);
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  }
  const std::string path = ::getenv("PATH");
  const PathIs first(folder.path("") + ":" + path);
  auto writer = VideoWriter::create(folder.path("run.mp4"), 640, 480);
  REQUIRE(writer);
  REQUIRE(*writer);
  Result<void> added;
  for (int i = 0; i < 20 && added; ++i)
    added = (*writer)->add(colored(640, 480, 0));  // more than a pipe holds
  REQUIRE_FALSE(added);
  CHECK(added.error().message.find("The disk is on fire") != std::string::npos);
  CHECK(added.error().message.find("exit code 3") != std::string::npos);
  CHECK(files_in(folder.path("")) == 1);  // the script
  sigset_t pending;
  sigpending(&pending);
  CHECK(sigismember(&pending, SIGPIPE) == 0);
}
