#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::picture;
using render::Inputs, render::Settings, render::View;

namespace {

Vec3d waves(double u, double v) { return {2 * u - 1, 0.3 * std::sin(7 * u + 2 * v), 1 - 2 * v}; }
Vec3d steep(double u, double v) { return {2 * u - 1, 0.5 * std::sin(9 * v), 1 - 2 * v}; }

Settings small() {
  Settings settings;
  settings.width = 150;
  settings.height = 101;
  settings.bounds = {{-1, -0.5F, -1}, {1, 0.5F, 1}};
  return settings;
}

}  // namespace

TEST_CASE("the same picture twice in a row has the same bits") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 60, waves, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.spheres = {{{0, -0.6, 0}, 0.4}};
  inputs.planes = {{{0, -1, 0}, {0, 1, 0}}};
  for (const View view : {View::Textured, View::Wireframe}) {
    Settings settings = small();
    settings.view = view;
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
    const Image first = value_of(offscreen.draw(0));
    CHECK(value_of(offscreen.draw(0)).rgba == first.rgba);
    auto again = value_of(Offscreen::create(fixture.device(), settings, inputs));
    CHECK(value_of(again.draw(0)).rgba == first.rgba);
  }
}

TEST_CASE("pictures arrive in the order in which they were drawn, without waiting for each") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 30, waves, 2, steep);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  auto offscreen = value_of(Offscreen::create(fixture.device(), small(), inputs));
  const std::array<Image, 2> expected = {value_of(offscreen.draw(0)), value_of(offscreen.draw(1))};
  REQUIRE(difference(expected[0], expected[1]) > 0);

  std::uint32_t drawn = 0, taken = 0;
  while (taken < 10) {
    if (drawn < 10 && !offscreen.full()) {
      gpu::CommandList list;
      offscreen.record(list, drawn++ % 2);
      REQUIRE(fixture.device().submit(list));
      offscreen.start();
    }
    const auto image = value_of(offscreen.try_take());
    if (!image) continue;
    CAPTURE(taken);
    CHECK(image->rgba == expected[taken % 2].rgba);
    ++taken;
  }
  CHECK(offscreen.pending() == 0);
  CHECK_FALSE(value_of(offscreen.try_take()));
}

TEST_CASE("a recorded list can be replayed while the ring stands at the same slot") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 10, waves, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  auto offscreen = value_of(Offscreen::create(fixture.device(), small(), inputs));
  gpu::CommandList list;
  offscreen.record(list, 0);
  REQUIRE(fixture.device().submit(list));
  REQUIRE(fixture.device().submit(list));
  offscreen.start();
  CHECK(value_of(offscreen.read()).rgba == value_of(offscreen.draw(0)).rgba);
}

TEST_CASE("a picture on a lost device is an error") {
  auto device = value_of(gpu::Device::create());
  const Sheet sheet(*device, 5, waves, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  auto offscreen = value_of(Offscreen::create(*device, small(), inputs));
  device->lose();
  const auto image = offscreen.draw(0);
  REQUIRE_FALSE(image);
  CHECK(image.error().kind == ErrorKind::DeviceLost);
}
