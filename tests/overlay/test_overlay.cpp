#include "overlay/overlay.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "../gpu/gpu_fixture.hpp"
#include "picture/image_ring.hpp"

using namespace weft;

namespace {

constexpr std::uint32_t kWidth = 40, kHeight = 24;
constexpr std::uint32_t kRed = 0xff0000ffU, kHalfGreen = 0x8000ff00U;

using Pixel = std::array<int, 3>;
Pixel at(const picture::Image& image, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* rgba = image.pixel(x, y);
  return {rgba[0], rgba[1], rgba[2]};
}

/// An atlas of 4 x 1 texels: opaque, half, none, opaque.
constexpr std::array<std::uint8_t, 4> kAtlas = {255, 128, 0, 255};
constexpr float kOpaque = 0.125F, kNone = 0.625F;  // u of the middle of a texel

void add_box(std::vector<overlay::Vertex>& vertices, const Vec4f& box, float u, std::uint32_t color,
             std::uint32_t clip) {
  const auto corner = [&](float x, float y) { vertices.push_back({x, y, u, 0.5F, color, clip}); };
  corner(box.x, box.y), corner(box.z, box.y), corner(box.x, box.w);
  corner(box.z, box.y), corner(box.z, box.w), corner(box.x, box.w);
}

gpu::Texture texture(gpu::Device& device, std::uint32_t width, std::uint32_t height) {
  auto made = gpu::Texture::create(device,
                                   {width, height, 1, gpu::TextureFormat::Rgba8Unorm,
                                    gpu::kRenderTarget | gpu::kSampled | gpu::kTextureCopySource},
                                   "test");
  REQUIRE(made);
  return std::move(*made);
}

picture::Image drawn(gpu::Device& device, overlay::Overlay& over) {
  const gpu::Texture target = texture(device, kWidth, kHeight);
  auto ring = picture::ImageRing::create(device, kWidth, kHeight);
  REQUIRE(ring);
  gpu::CommandList list;
  over.record(list, target.view(), kWidth, kHeight);
  ring->record(list, target);
  REQUIRE(device.submit(list));
  ring->start();
  auto image = ring->take();
  REQUIRE(image);
  return std::move(*image);
}

overlay::Overlay made(gpu::Device& device) {
  auto over = overlay::Overlay::create(device, gpu::TextureFormat::Rgba8Unorm, kAtlas, 4, 1);
  REQUIRE(over);
  return std::move(*over);
}

}  // namespace

TEST_CASE("a triangle of the overlay covers its pixels within its own clip, and no other") {
  GpuFixture gpu;
  overlay::Overlay over = made(gpu.device());
  std::vector<overlay::Vertex> vertices;
  add_box(vertices, {2, 3, 12, 9}, kOpaque, kRed, 0);
  add_box(vertices, {20, 3, 30, 9}, kOpaque, kRed, 1);
  const std::array<Vec4f, 2> clips = {{{0, 0, kWidth, kHeight}, {22, 0, 26, kHeight}}};
  REQUIRE(over.set_triangles(vertices, clips));
  const picture::Image image = drawn(gpu.device(), over);
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const bool inside = y >= 3 && y < 9 && ((x >= 2 && x < 12) || (x >= 22 && x < 26));
      CHECK(at(image, x, y) == (inside ? Pixel{255, 0, 0} : Pixel{0, 0, 0}));
    }
}

TEST_CASE("the overlay's alpha is its colour's times the atlas's, over what lies below") {
  GpuFixture gpu;
  overlay::Overlay over = made(gpu.device());
  std::vector<overlay::Vertex> vertices;
  add_box(vertices, {0, 0, 40, 24}, kOpaque, kRed, 0);
  add_box(vertices, {0, 0, 10, 24}, kOpaque, kHalfGreen, 0);
  add_box(vertices, {10, 0, 20, 24}, 0.375F, kHalfGreen, 0);
  add_box(vertices, {20, 0, 30, 24}, kNone, kHalfGreen, 0);
  const std::array<Vec4f, 1> clips = {{{0, 0, kWidth, kHeight}}};
  REQUIRE(over.set_triangles(vertices, clips));
  const picture::Image image = drawn(gpu.device(), over);
  const auto near = [](const Pixel& found, double alpha) {  // one byte: a host rounds as it likes
    return std::abs(found[0] - 255 * (1 - alpha)) <= 1 && std::abs(found[1] - 255 * alpha) <= 1 &&
           found[2] == 0;
  };
  constexpr double kHalf = 128 / 255.0;
  CHECK(near(at(image, 5, 5), kHalf));
  CHECK(near(at(image, 15, 5), kHalf * kHalf));
  CHECK(at(image, 25, 5) == Pixel{255, 0, 0});
  CHECK(at(image, 35, 5) == Pixel{255, 0, 0});
}

TEST_CASE("a picture lies at its place below the triangles, pixel by pixel") {
  GpuFixture gpu;
  gpu::Device& device = gpu.device();
  const gpu::Texture picture = texture(device, 8, 6);
  overlay::Overlay source = made(device);
  std::vector<overlay::Vertex> vertices;
  add_box(vertices, {0, 0, 8, 6}, kOpaque, 0xffff0000U, 0);
  add_box(vertices, {7, 5, 8, 6}, kOpaque, 0xff00ff00U, 0);  // its last pixel alone
  const std::array<Vec4f, 1> clips = {{{0, 0, kWidth, kHeight}}};
  REQUIRE(source.set_triangles(vertices, clips));
  gpu::CommandList list;
  source.record(list, picture.view(), 8, 6);
  REQUIRE(device.submit(list));

  overlay::Overlay over = made(device);
  REQUIRE(over.set_picture(picture, 3, 4));
  vertices.clear();
  add_box(vertices, {3, 4, 4, 5}, kOpaque, kRed, 0);
  REQUIRE(over.set_triangles(vertices, clips));
  const picture::Image image = drawn(device, over);
  CHECK(at(image, 3, 4) == Pixel{255, 0, 0});
  CHECK(at(image, 4, 4) == Pixel{0, 0, 255});
  CHECK(at(image, 9, 9) == Pixel{0, 0, 255});
  CHECK(at(image, 10, 9) == Pixel{0, 255, 0});
  CHECK(at(image, 11, 9) == Pixel{0, 0, 0});
  CHECK(at(image, 10, 10) == Pixel{0, 0, 0});
  CHECK(at(image, 2, 4) == Pixel{0, 0, 0});
}

TEST_CASE("the overlay has room for as many triangles as come, and forgets those before") {
  GpuFixture gpu;
  overlay::Overlay over = made(gpu.device());
  const std::array<Vec4f, 1> clips = {{{0, 0, kWidth, kHeight}}};
  std::vector<overlay::Vertex> vertices;
  for (int i = 0; i < 500; ++i) add_box(vertices, {0, 0, 10, 10}, kNone, kRed, 0);
  add_box(vertices, {30, 20, 40, 24}, kOpaque, kRed, 0);
  REQUIRE(over.set_triangles(vertices, clips));
  CHECK(at(drawn(gpu.device(), over), 35, 22) == Pixel{255, 0, 0});
  REQUIRE(over.set_triangles({}, {}));
  CHECK(at(drawn(gpu.device(), over), 35, 22) == Pixel{0, 0, 0});
}

TEST_CASE("an atlas of another size than it says is refused with both") {
  GpuFixture gpu;
  const auto refused = overlay::Overlay::create(gpu.device(), gpu::TextureFormat::Rgba8Unorm, kAtlas, 8, 1);
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Shape);
  CHECK(refused.error().message == "An atlas of 8 x 1 texels does not have 4 alphas in rows of whole words.");
}
