#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image, picture::Offscreen;

namespace {

/// A point [m] as a place in the picture, each axis in [0, 1].
std::array<double, 2> place(const Camera& camera, double aspect, const Vec3d& point) {
  const auto clip = view_projection(camera, aspect, 0.1, 100).apply(point);
  return {0.5 + 0.5 * clip[0] / clip[3], 0.5 - 0.5 * clip[1] / clip[3]};
}

}  // namespace

TEST_CASE("a shadow lies where the sun's rays say, and not beside it") {
  GpuFixture fixture;
  // A sheet of 1 m at height 1 m, over a floor at height 0; the sun comes from (-1, 2, 0), so that the shadow
  // is moved by 1 / 2 m along x: from 0 to 1 m instead of -0.5 to 0.5 m.
  const auto level = [](double u, double v) { return Vec3d{u - 0.5, 1, 0.5 - v}; };
  const Sheet sheet(fixture.device(), 11, level);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.planes = {{{0, 0, 0}, {0, 1, 0}}};
  Settings settings;
  settings.width = 400;
  settings.height = 300;
  settings.bounds = {{-0.7F, 0, -0.7F}, {1.2F, 1, 0.7F}};
  settings.to_light = Vec3d{-1, 2, 0};
  settings.camera = Camera{{0.5, 2.5, 5}, {0.4, 0.3, 0}, 35};
  const double aspect = 400.0 / 300.0;
  auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
  const Image image = value_of(offscreen.draw(0));
  const auto at = [&](double x, double z) {
    const auto [u, v] = place(*settings.camera, aspect, {x, 0, z});
    return brightness(image, u, v, 1);
  };
  const double lit = at(1.3, 0.3);
  for (const double z : {-0.1, 0.1, 0.3, 0.45}) {
    CAPTURE(z);
    CHECK(at(0.5, z) < 0.75 * lit);
    CHECK(at(0.95, z) < 0.75 * lit);
    CHECK(at(1.05, z) > 0.9 * lit);
    CHECK(at(-0.05, z) > 0.9 * lit);
  }
  CHECK(at(0.5, 0.55) > 0.9 * lit);
}

TEST_CASE("a floor below the bounds gets its shadow, also from what has risen above them") {
  GpuFixture fixture;
  for (const double height : {0.0, 3.0}) {  // bounds hold heights of -0.1 to 0.1 m; the floor lies at -1 m
    const auto level = [&](double u, double v) { return Vec3d{u - 0.5, height, 0.5 - v}; };
    const Sheet sheet(fixture.device(), 11, level);
    Inputs inputs;
    inputs.cloth = sheet.draw();
    inputs.planes = {{{0, -1, 0}, {0, 1, 0}}};
    Settings settings;
    settings.width = 400;
    settings.height = 300;
    settings.bounds = {{-0.7F, -0.1F, -0.7F}, {0.7F, 0.1F, 0.7F}};
    settings.to_light = Vec3d{0, 1, 0};
    settings.camera = Camera{{0, 0, 4}, {0, -0.6, 0}, 40};
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
    const Image image = value_of(offscreen.draw(0));
    const auto at = [&](double x, double z) {
      const auto [u, v] = place(*settings.camera, 400.0 / 300.0, {x, -1, z});
      return brightness(image, u, v, 1);
    };
    CAPTURE(height);
    CHECK(at(0.4, 0.4) < 0.8 * at(0.6, 0.4));
    CHECK(at(-0.4, 0.4) < 0.8 * at(-0.6, 0.4));
  }
}

TEST_CASE("a lit surface does not shade itself") {
  GpuFixture fixture;
  // A sphere and a level sheet under a sun that stands 80 degrees from the zenith: every lit pixel of the
  // sheet has the same brightness, within a step of the 8-bit target and the sheen's change over the picture.
  const auto level = [](double u, double v) { return Vec3d{2 * u - 1, 0, 1 - 2 * v}; };
  const Sheet sheet(fixture.device(), 30, level, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.cloth.ranges[0].color = Vec3d{1, 1, 1};
  inputs.cloth.ranges[0].sheet_size = 1e6;  // one colour: the stripes are kilometres wide
  Settings settings;
  settings.width = 320;
  settings.height = 240;
  settings.bounds = {{-1, -1, -1}, {1, 1, 1}};
  settings.to_light = Vec3d{std::sin(1.396), std::cos(1.396), 0.2};
  settings.camera = Camera{{0, 8, 0.01}, {0, 0, 0}, 12};
  auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
  const Image image = value_of(offscreen.draw(0));
  double low = 255, high = 0;
  for (double u = 0.1; u < 0.9; u += 0.01)
    for (double v = 0.1; v < 0.9; v += 0.01) {
      const double here = brightness(image, u, v, 0);
      low = std::min(low, here);
      high = std::max(high, here);
    }
  CHECK(high - low < 6);
}

TEST_CASE("the ground's shadow is drawn on request, and only where there is no floor") {
  GpuFixture fixture;
  const auto level = [](double u, double v) { return Vec3d{u - 0.5, 1, 0.5 - v}; };
  const Sheet sheet(fixture.device(), 11, level);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  Settings settings;
  settings.width = 320;
  settings.height = 240;
  settings.bounds = {{-1, 0, -1}, {1, 1, 1}};
  const auto draw = [&] {
    return value_of(value_of(Offscreen::create(fixture.device(), settings, inputs)).draw(0));
  };
  const Image without = draw();
  settings.ground_shadow = true;
  const Image with = draw();
  const std::size_t shaded = difference(without, with, 10);
  CHECK(shaded > 500);
  CHECK(shaded < 320 * 240 / 4);
  inputs.planes = {{{0, 0, 0}, {0, 1, 0}}};
  const Image floor = draw();
  settings.ground_shadow = false;
  CHECK(difference(floor, draw()) == 0);
}

TEST_CASE("a floor seen from below does not hide the scene") {
  GpuFixture fixture;
  const auto upright = [](double u, double v) { return Vec3d{u - 0.5, v, 0}; };
  const Sheet sheet(fixture.device(), 5, upright);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  Settings settings;
  settings.width = 200;
  settings.height = 150;
  settings.bounds = {{-0.5F, 0, -0.5F}, {0.5F, 1, 0.5F}};
  settings.camera = Camera{{0, -2, 3}, {0, 0.5, 0}, 35};
  const auto draw = [&] {
    return value_of(value_of(Offscreen::create(fixture.device(), settings, inputs)).draw(0));
  };
  const Image without = draw();
  inputs.planes = {{{0, -0.2, 0}, {0, 1, 0}}};
  CHECK(difference(without, draw()) == 0);
}
