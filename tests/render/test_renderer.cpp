#include "picture/image_ring.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image;

namespace {

Vec3d waves(double u, double v) { return {2 * u - 1, 0.3 * std::sin(7 * u + 2 * v), 1 - 2 * v}; }

Settings small() {
  Settings settings;
  settings.width = 150;
  settings.height = 101;
  settings.bounds = {{-1, -0.5F, -1}, {1, 0.5F, 1}};
  return settings;
}

/// Draws into a texture of the test's own and brings its bytes to the host.
Image draw(gpu::Device& device, const Renderer& renderer, const Settings& settings) {
  const gpu::TextureInfo info = {settings.width, settings.height, 1, kColorFormat,
                                 gpu::kRenderTarget | gpu::kTextureCopySource};
  const auto target = value_of(gpu::Texture::create(device, info, "target"));
  auto ring = value_of(picture::ImageRing::create(device, settings.width, settings.height));
  gpu::CommandList list;
  renderer.record(list, 0, target.view());
  ring.record(list, target);
  REQUIRE(device.submit(list));
  ring.start();
  return value_of(ring.take());
}

}  // namespace

TEST_CASE("a camera that is moved changes the next picture, and back gives the first again") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 10, waves, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  auto renderer = value_of(Renderer::create(fixture.device(), small(), inputs));
  const Camera before = renderer.camera();
  const Image first = draw(fixture.device(), renderer, small());
  Camera nearer = before;
  nearer.eye = 0.5 * (before.eye + before.target);
  renderer.set_camera(nearer);
  CHECK(difference(draw(fixture.device(), renderer, small()), first) > 1000);
  renderer.set_camera(before);
  CHECK(draw(fixture.device(), renderer, small()).rgba == first.rgba);
}
