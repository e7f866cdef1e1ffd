#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"
#include "scene/looks.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image, picture::Offscreen;

namespace {

/// A point [m] as a place in the picture, each axis in [0, 1].
std::array<double, 2> place(const Camera& camera, double aspect, const Vec3d& point) {
  const auto clip = view_projection(camera, aspect, 0.1, 100).apply(point);
  return {0.5 + 0.5 * clip[0] / clip[3], 0.5 - 0.5 * clip[1] / clip[3]};
}

/// The brightest channel's radiance before the tone curve of frame.wgsl, of a byte of the picture.
double radiance(std::uint8_t byte) {
  constexpr double kShoulder = 0.76, kRoom = 1 - kShoulder;
  const double peak = static_cast<double>(srgb_to_linear(static_cast<float>(byte) / 255));
  return peak < kShoulder ? peak : kRoom * kRoom / (1 - peak) - kRoom + kShoulder;
}
/// The red channel's, brightest on the floor in the studio's light, as a mean over 2 * reach + 1 pixels along y.
double red(const Image& image, double u, double v, int reach = 0) {
  const auto x = static_cast<std::uint32_t>(u * image.width);
  const int y = static_cast<int>(v * image.height);
  double sum = 0;
  for (int dy = -reach; dy <= reach; ++dy)
    sum += radiance(image.pixel(x, static_cast<std::uint32_t>(y + dy))[0]) / (2 * reach + 1);
  return sum;
}

}  // namespace

TEST_CASE(
    "a penumbra is as wide as the distance of the edge times the sun's angle, and has the profile of a "
    "disc") {
  GpuFixture fixture;
  // The edge of a wide level sheet at a height h over a floor, under a sun 27 degrees off the zenith towards -x. Along
  // the ray the edge is h sqrt(5) / 2 away; the floor cuts the cone at a slant: the penumbra is sqrt(5) / 2 wider.
  const double pi = 3.14159265358979;
  for (const double height : {0.5, 1.0})
    for (const double degrees : {4.0, 10.0}) {
      CAPTURE(height);
      CAPTURE(degrees);
      const auto level = [&](double u, double v) {
        return Vec3d{3 * u - 3, height, 2 - 4 * v};
      };  // edge at x = 0
      const Sheet sheet(fixture.device(), 9, level);
      Inputs inputs;
      inputs.cloth = sheet.draw();
      inputs.planes = {{{0, 0, 0}, {0, 1, 0}}};
      Settings settings;
      settings.width = 800;
      settings.height = 300;
      settings.bounds = {{-3, 0, -2}, {1, 1, 2}};
      settings.to_light = Vec3d{-1, 2, 0};
      settings.lighting.sun_degrees = degrees;
      const double edge = 0.5 * height;
      settings.camera = Camera{{edge + 1.5, 1.6, 0.02}, {edge, 0, 0.02}, 20};
      auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
      const Image image = value_of(offscreen.draw(0));
      settings.camera->target = Vec3d{edge, 0, 0.02};
      const auto at = [&](double x) {
        const auto [u, v] = place(*settings.camera, 800.0 / 300.0, {x, 0, 0.02});
        return red(image, u, v);
      };
      const double half = height * 1.25 * std::tan(0.5 * degrees * pi / 180);  // of the penumbra, along x
      const double dark = at(edge - 1.6 * half - 0.03), lit = at(edge + 1.6 * half + 0.03);
      CHECK(lit > 1.5 * dark);
      double squares = 0;
      int count = 0;
      for (double s = -1.4; s <= 1.4; s += 0.1) {  // in halves of the penumbra, from its middle
        const double c = std::clamp(s, -1.0, 1.0);
        const double seen = 0.5 + (std::asin(c) + c * std::sqrt(1 - c * c)) / pi;  // of a disc behind an edge
        const double found = (at(edge + s * half) - dark) / (lit - dark);
        CAPTURE(s);
        CAPTURE(found);
        CHECK(std::abs(found - seen) < 0.15);
        squares += (found - seen) * (found - seen);
        ++count;
      }
      CHECK(std::sqrt(squares / count) < 0.06);
    }
}

TEST_CASE("of the sky a floor beside a wall sees what the wall's angle leaves") {
  GpuFixture fixture;
  // A long wall of height h at x = 0: at a distance d the cosine-weighted part of the sky that stays open is
  // (1 + d / sqrt(d^2 + h^2)) / 2 (the form factor of a strip at right angles). The sun is below, so not seen.
  const double height = 0.4;
  Inputs inputs;
  const Sheet sheet(fixture.device(), 3, [](double u, double v) { return Vec3d{50 + u, 0.1, v}; });
  inputs.cloth = sheet.draw();
  inputs.planes = {{{0, 0, 0}, {0, 1, 0}}};
  inputs.boxes = {{{-0.5, 0.5 * height, 0}, {1, height, 40}}};
  Settings settings;
  settings.width = 640;
  settings.height = 480;
  settings.bounds = {{-10, -10, -10},
                     {10, 10, 10}};  // sky is kept away within 0.6 x 0.15 x 17.3 m = 1.56 m wholly
  settings.to_light = Vec3d{0, -1, 0};
  settings.camera = Camera{{3.2, 2.6, 1.6}, {0.9, 0, 0}, 40};
  auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
  const Image image = value_of(offscreen.draw(0));
  const auto at = [&](double d) {
    const auto [u, v] = place(*settings.camera, 640.0 / 480.0, {d, 0, 0});
    double sum = 0;
    for (int k = -4; k <= 4; ++k) {
      const auto x = static_cast<std::uint32_t>(u * 640), y = static_cast<std::uint32_t>(v * 480 + k % 3);
      sum += srgb_to_linear(static_cast<float>(image.pixel(x, y)[1]) / 255) / 9;
    }
    return sum;
  };
  // What light the floor sends once more into the corner is in lit_by, a cubic of the open part (Jimenez et al. 2016).
  const double albedo = 0.5;  // of the floor's squares, within 0.04
  const auto lit_by = [&](double open) {
    const double a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return std::max(open, ((open * a + b) * open + c) * open);
  };
  const double open_floor = at(1.9);
  for (const double d : {0.1, 0.2, 0.3, 0.45, 0.6, 0.9}) {
    const double expected =
        lit_by(0.5 * (1 + d / std::hypot(d, height))) / lit_by(0.5 * (1 + 1.9 / std::hypot(1.9, height)));
    CAPTURE(d);
    CAPTURE(at(d) / open_floor);
    CHECK(std::abs(at(d) / open_floor - expected) < 0.06);
  }
}

TEST_CASE("views of numbers take nothing from looks, materials and light") {
  GpuFixture fixture;
  const Sheet sheet(
      fixture.device(), 15,
      [](double u, double v) {
        return Vec3d{2 * u - 1, 0.3 * u * v, 1 - 2 * v};
      },
      2);
  for (const View view : {View::Wireframe, View::Normals, View::Stretch, View::Velocity, View::Contacts}) {
    CAPTURE(scene::name_of(view));
    const auto draw = [&](bool changed) {
      Inputs inputs;
      inputs.cloth = sheet.draw();
      inputs.cloth.ranges[0].rim = {2.0, 2.0};
      inputs.spheres = {{{0.2, 0.6, 0.3}, 0.3}};
      inputs.planes = {{{0, -0.1, 0}, {0, 1, 0}}};
      Settings settings;
      settings.width = 160;
      settings.height = 120;
      settings.view = view;
      settings.bounds = {{-1, -0.1F, -1}, {1, 0.9F, 1}};
      if (changed) {
        inputs.cloth.ranges[0].look = scene::look_of("silk");
        inputs.spheres[0].material = scene::Material::Marble;
        settings.lighting = {scene::Environment::Sky, 20};
      }
      return value_of(value_of(Offscreen::create(fixture.device(), settings, inputs)).draw(0));
    };
    CHECK(draw(false).rgba == draw(true).rgba);
  }
}

TEST_CASE("no weave beats with the pixels at any distance") {
  GpuFixture fixture;
  // A flat sheet under even light, seen from 0.08 to 12 m: 28 threads a centimetre are from a pixel to a hundredth of
  // one wide. Uneven yarns and threads' relief are seen from near; none of it may come back where threads are thinner
  // than 2 pixels and have faded into their mean. Half a step of the 8-bit target is what rounding may add.
  const Sheet sheet(
      fixture.device(), 3,
      [](double u, double v) {
        return Vec3d{8 * u - 4, 8 * v - 4, 0};
      },
      8);
  for (const char* look : {"cotton", "denim", "silk", "sweater"}) {
    std::vector<double> nearer, even;
    for (const double distance : {0.08, 0.15, 0.3, 0.6, 1.2, 2.5, 5.0, 8.0, 12.0}) {
      Inputs inputs;
      inputs.cloth = sheet.draw();
      inputs.cloth.ranges[0].look = scene::look_of(look);
      Settings settings;
      settings.width = 160;
      settings.height = 120;
      settings.bounds = {{-4, -4, -0.5F}, {4, 4, 0.5F}};
      settings.to_light = Vec3d{1, 0.5, 0.6};  // no highlight, which would change over the picture
      settings.camera = Camera{{0.1, 0.07, distance}, {0.1, 0.07, 0}, 35};
      const Image image = value_of(value_of(Offscreen::create(fixture.device(), settings, inputs)).draw(0));
      double sum = 0, squares = 0;
      const int count = 80 * 60;
      for (std::uint32_t y = 30; y < 90; ++y)
        for (std::uint32_t x = 40; x < 120; ++x) {
          const double here = image.pixel(x, y)[1];
          sum += here;
          squares += here * here;
        }
      const double deviation = std::sqrt(std::max(squares / count - sum * sum / count / count, 0.0));
      CAPTURE(std::string(look));
      CAPTURE(distance);
      CAPTURE(deviation);
      const double pitch = 0.01 / scene::look_of(look).threads_per_cm;
      const double threads_a_pixel = 2 * distance * std::tan(17.5 * 3.14159265358979 / 180) / 120 / pitch;
      if (threads_a_pixel > 0.5 && !nearer.empty())
        CHECK(deviation < nearer.back() + 0.5);  // fades, and stays away
      if (threads_a_pixel > 80) even.push_back(deviation);
      nearer.push_back(deviation);
    }
    // All streaks are below a pixel there too: what is left is the sheet's own shading, which no distance changes.
    CAPTURE(std::string(look));
    for (const double deviation : even) CHECK(std::abs(deviation - even.back()) < 0.5);
  }
}

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
  settings.width = 800;
  settings.height = 600;
  settings.bounds = {{-0.7F, 0, -0.7F}, {1.2F, 1, 0.7F}};
  settings.to_light = Vec3d{-1, 2, 0};
  settings.lighting.sun_degrees = 0.5;  // where the shadow is, not how soft: a penumbra is 11 mm wide here
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
