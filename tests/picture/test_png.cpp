#include <doctest/doctest.h>

#include <filesystem>

#include "base/file.hpp"
#include "base/random.hpp"
#include "picture/png.hpp"
#include "picture/png_writer.hpp"
#include "temporary_folder.hpp"

#define STBI_ONLY_PNG
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

using namespace weft;
using namespace weft::picture;

namespace {

Image noise(std::uint32_t width, std::uint32_t height, std::uint64_t seed, bool opaque = true) {
  Random random(seed);
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random.below(256));
  return image;
}

Image read(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &width, &height, &channels, 4);
  REQUIRE(pixels != nullptr);
  Image image{
      static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
      std::vector<std::uint8_t>(pixels, pixels + std::size_t{4} * static_cast<std::size_t>(width * height))};
  stbi_image_free(pixels);
  return image;
}

}  // namespace

TEST_CASE("a PNG file reads back to the same pixels, with and without alpha, at any size") {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair{1U, 1U}, {3U, 2U}, {640U, 1U}, {333U, 127U}})
    for (const bool opaque : {true, false}) {
      const Image image = noise(width, height, width + height, opaque);
      REQUIRE(write_png(folder.path("a.png"), image));
      const Image again = read(folder.path("a.png"));
      CHECK(again.width == width);
      CHECK(again.height == height);
      CHECK(again.rgba == image.rgba);
    }
}

TEST_CASE("a PNG that cannot be written is an error that names the place") {
  const auto written = write_png("/nowhere/a.png", noise(4, 4, 1));
  REQUIRE_FALSE(written);
  CHECK(written.error().message.find("/nowhere/a.png") != std::string::npos);
}

TEST_CASE("the writer's thread writes every picture, however many wait") {
  const TemporaryFolder folder;
  PngWriter writer(2);
  for (std::uint32_t i = 0; i < 20; ++i)
    REQUIRE(writer.push(folder.path(std::to_string(i) + ".png"), noise(100, 50, i)));
  REQUIRE(writer.finish());
  for (std::uint32_t i = 0; i < 20; ++i)
    CHECK(read(folder.path(std::to_string(i) + ".png")).rgba == noise(100, 50, i).rgba);
  REQUIRE(writer.push(folder.path("later.png"), noise(5, 5, 0)));  // it can go on after finish
  REQUIRE(writer.finish());
  CHECK(std::filesystem::exists(folder.path("later.png")));
}

TEST_CASE("a writer that is given up still writes what waits") {
  const TemporaryFolder folder;
  {
    PngWriter writer(8);
    for (int i = 0; i < 5; ++i)
      REQUIRE(writer.push(folder.path(std::to_string(i) + ".png"), noise(64, 64, 1)));
  }
  for (int i = 0; i < 5; ++i) CHECK(std::filesystem::exists(folder.path(std::to_string(i) + ".png")));
}

TEST_CASE("the writer keeps its first error, and writes nothing after it") {
  const TemporaryFolder folder;
  PngWriter writer(1);
  CHECK(writer.push("/nowhere/first.png", noise(8, 8, 1)));
  while (writer.push("/nowhere/second.png", noise(8, 8, 1))) {
  }
  CHECK(writer.finish().error().message.find("first.png") != std::string::npos);
  CHECK_FALSE(writer.push(folder.path("third.png"), noise(8, 8, 1)));
  CHECK_FALSE(std::filesystem::exists(folder.path("third.png")));
}
