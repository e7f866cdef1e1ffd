#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image, picture::Offscreen;

namespace {

Vec3d waves(double u, double v) {
  return {2 * u - 1, 0.62 + 0.08 * std::sin(9 * u) * std::cos(4 * v), 1 - 2 * v};
}
Vec3d square(double u, double v) { return {2 * u - 1, 2 * v - 1, 0}; }  // 2 m x 2 m, faces +z

Settings settings_for(const mesh::Bounds& bounds, View view = View::Textured) {
  Settings settings;
  settings.width = 200;  // rows of 800 bytes, not a multiple of 256
  settings.height = 150;
  settings.view = view;
  settings.bounds = bounds;
  return settings;
}

/// The square seen along -z from 10 m, so that a metre is `height` / (20 tan(fov / 2)) pixels.
Settings frontal(View view) {
  Settings settings = settings_for({{-1, -1, -0.5F}, {1, 1, 0.5F}}, view);
  settings.camera = Camera{{0, 0, 10}, {0, 0, 0}, 20};
  return settings;
}

/// Whether a pixel is 255 (0.5 + 0.5 n) with n = +z; 127.5 is rounded either way.
bool is_blue(const std::uint8_t* pixel) {
  return pixel[0] - 127U <= 1 && pixel[1] - 127U <= 1 && pixel[2] == 255;
}
bool is_blue(const Image& image, double u, double v) {
  return is_blue(
      image.pixel(static_cast<std::uint32_t>(u * image.width), static_cast<std::uint32_t>(v * image.height)));
}

}  // namespace

TEST_CASE("each view of a waved sheet over a sphere shows something, and something else") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 40, waves, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.spheres = {{{0, 0, 0}, 0.5}};
  inputs.objects = {{{{{-1, -0.5F, 1}, {-0.6F, -0.5F, 1}, {-0.8F, 0.2F, 1}}, {{0, 1, 2}}}}};  // open
  std::vector<Image> images;
  for (const View view : {View::Textured, View::Wireframe, View::Normals, View::Stretch}) {
    Settings settings = settings_for({{-1, -0.5F, -1}, {1, 0.7F, 1}}, view);
    settings.camera =
        Camera{{1.5, 3.2, 2.6}, {0, 0, 0}, 35};  // from above: the sheet fills half of the picture
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
    images.push_back(value_of(offscreen.draw(0)));
    CAPTURE(scene::name_of(view));
    CHECK(images.back().rgba.size() == 200 * 150 * 4);
    CHECK(color_count(images.back()) > 200);
    CHECK(brightness(images.back(), 0.5, 0.5, 30) > 20);
    CHECK(brightness(images.back(), 0.5, 0.5, 30) < 235);
  }
  for (std::size_t a = 0; a < images.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) CHECK(difference(images[a], images[b], 8) > 200 * 150 / 10);
}

TEST_CASE("a flat square covers the pixels that geometry says, and its normal is blue") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 5, square, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  for (const std::uint32_t width : {64U, 200U, 255U, 333U}) {  // three of four are not multiples of 64 pixels
    Settings settings = frontal(View::Normals);
    settings.width = width;
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
    const Image image = value_of(offscreen.draw(0));
    std::size_t covered = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) covered += is_blue(&image.rgba[i]);
    const double side = 2 * 150 / (20 * std::tan(10 * 3.14159265358979 / 180));  // pixels: 85.07
    CAPTURE(width);
    const double visible = std::min(side, static_cast<double>(width));
    CHECK(static_cast<double>(covered) > (visible - 2) * (side - 2));  // a pixel on an edge is a mixture
    CHECK(static_cast<double>(covered) <= visible * side);
  }
}

TEST_CASE("parity chooses the buffer that is drawn") {
  GpuFixture fixture;
  const auto aside = [](double u, double v) { return square(u, v) + Vec3d{1.0, 0, 0}; };
  const Sheet sheet(fixture.device(), 5, square, 2, aside);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  Settings settings = frontal(View::Normals);
  settings.bounds.high.x = 2;
  auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
  const Image here = value_of(offscreen.draw(0)), there = value_of(offscreen.draw(1));
  const double left = 0.5 - 0.7 * 42.5 / 200, right = 0.5 + 1.5 * 42.5 / 200;  // 1 m is 42.5 pixels
  CHECK(is_blue(here, left, 0.5));
  CHECK_FALSE(is_blue(here, right, 0.5));
  CHECK_FALSE(is_blue(there, left, 0.5));
  CHECK(is_blue(there, right, 0.5));
}

TEST_CASE("front and back of a cloth have different colours, and normals face the eye from both sides") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 5, square, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.cloth.ranges[0].color = Vec3d{0.2, 0.3, 0.9};
  const auto middle = [&](View view, double side) {
    Settings settings = frontal(view);
    settings.camera->eye.z *= side;
    settings.to_light = Vec3d{0, 0.5, side};  // light the side that is seen
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs));
    const Image image = value_of(offscreen.draw(0));
    std::array<double, 3> sum{};
    for (std::uint32_t y = 45; y < 105; ++y)
      for (std::uint32_t x = 70; x < 130; ++x)
        for (std::size_t channel = 0; channel < 3; ++channel)
          sum[channel] += image.pixel(x, y)[channel] / 3600.0;
    return sum;
  };
  const auto front = middle(View::Textured, 1), back = middle(View::Textured, -1);
  CHECK(front[2] > front[0] + 40);                                         // blue
  CHECK(back[2] - back[0] < 0.5 * (front[2] - front[0]));                  // turned towards the complement
  CHECK(middle(View::Normals, -1)[2] == doctest::Approx(0).epsilon(0.5));  // -z
}

TEST_CASE("every cloth of a state is drawn in its own colour") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 5, square, 2);  // 32 triangles: the lower half, then the upper
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.cloth.ranges = {{0, 16, Vec3d{0.9, 0.1, 0.1}, 2.0}, {16, 16, Vec3d{0.1, 0.1, 0.9}, 2.0}};
  for (const View view : {View::Textured, View::Wireframe}) {
    auto offscreen = value_of(Offscreen::create(fixture.device(), frontal(view), inputs));
    const Image image = value_of(offscreen.draw(0));
    const auto red_less_blue = [&](std::uint32_t top) {
      double sum = 0;
      for (std::uint32_t y = top; y < top + 30; ++y)
        for (std::uint32_t x = 70; x < 130; ++x) sum += int{image.pixel(x, y)[0]} - int{image.pixel(x, y)[2]};
      return sum;
    };
    CAPTURE(scene::name_of(view));
    CHECK(red_less_blue(40) < 0);
    CHECK(red_less_blue(80) > 0);
  }
}

TEST_CASE("a wireframe shows the sides of triangles and hides what lies behind") {
  GpuFixture fixture;
  const auto two_layers = [](double u, double v) {  // the upper half of the sheet is folded behind the lower
    return v <= 0.5 ? Vec3d{2 * u - 1, 4 * v - 1, 0} : Vec3d{2 * u - 1, 3 - 4 * v, -0.3};
  };
  const auto row = [&](const Shape& shape) {
    const Sheet sheet(fixture.device(), 5, shape, 2);
    Inputs inputs;
    inputs.cloth = sheet.draw();
    auto offscreen = value_of(Offscreen::create(fixture.device(), frontal(View::Wireframe), inputs));
    const Image image = value_of(offscreen.draw(0));
    return image;
  };
  const Image flat = row(square);
  // Vertical edges stand at x = -1, -0.5, 0, 0.5, 1 m; 42.5 pixels a metre; cells are dark between them.
  const double on_edge = brightness(flat, 0.5, 0.5 - 10.0 / 150, 0);
  const double in_cell = brightness(flat, 0.5 + 14.0 / 200, 0.5 - 6.0 / 150, 0);
  CHECK(on_edge > in_cell + 40);
  // At the same places of the nearer layer nothing of the farther one shines through.
  const Image folded = row(two_layers);
  CHECK(brightness(folded, 0.5, 0.5 - 10.0 / 150, 0) >
        brightness(folded, 0.5 + 14.0 / 200, 0.5 - 6.0 / 150, 0) + 40);
}

TEST_CASE("stretch, speed and contacts go through the colour map from the lowest to the highest value") {
  GpuFixture fixture;
  const auto stretched = [](double u, double v) {
    return Vec3d{2 * u - 1 + 0.3 * (u * u - u), 2 * v - 1, 0};
  };
  const Sheet sheet(fixture.device(), 21, stretched, 2);  // dx/du / 2 = 1 + 0.15 (2 u - 1): from 0.85 to 1.15
  Inputs inputs;
  inputs.cloth = sheet.draw();
  for (const View view : {View::Stretch, View::Velocity, View::Contacts}) {
    CAPTURE(static_cast<int>(view));
    Settings settings = frontal(view);
    settings.range = Range{0.85, 1.15};
    settings.to_light = Vec3d{0, 0, 1};  // faces the sheet: full light, the map's own colour
    auto offscreen = value_of(Offscreen::create(fixture.device(), settings, inputs, false));
    const Image image = value_of(offscreen.draw(0));
    for (const double u : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double x = 0.5 + (2 * u - 1 + 0.3 * (u * u - u)) * 42.53 / 200;
      const Vec3f expected = 255.0F * map_color(static_cast<float>(u));
      const std::uint8_t* pixel = image.pixel(static_cast<std::uint32_t>(x * 200), 75);
      CAPTURE(u);
      CHECK(std::abs(static_cast<float>(pixel[0]) - expected.x) < 9);  // a pixel is 1.2 % of the map
      CHECK(std::abs(static_cast<float>(pixel[1]) - expected.y) < 9);
      CHECK(std::abs(static_cast<float>(pixel[2]) - expected.z) < 9);
    }
  }
}

TEST_CASE("a buffer that is missing or of another size is refused in words") {
  GpuFixture fixture;
  const Sheet sheet(fixture.device(), 5, square, 2);
  Inputs inputs;
  inputs.cloth = sheet.draw();
  inputs.cloth.stretch = nullptr;
  CHECK(Offscreen::create(fixture.device(), frontal(View::Textured), inputs));  // needed in one view only
  const auto missing = Offscreen::create(fixture.device(), frontal(View::Stretch), inputs);
  REQUIRE_FALSE(missing);
  CHECK(missing.error().message == "View stretch needs buffer stretch.");
  inputs.cloth.velocity[1] = nullptr;
  CHECK(Offscreen::create(fixture.device(), frontal(View::Velocity), inputs).error().message ==
        "View velocity needs buffer velocity.");
  inputs.cloth.contacts = nullptr;
  const auto no_pairs = Offscreen::create(fixture.device(), frontal(View::Contacts), inputs);
  REQUIRE_FALSE(no_pairs);
  CHECK(no_pairs.error().kind == ErrorKind::Input);
  CHECK(no_pairs.error().message ==
        "View contacts shows the pairs of contact method proximity, and this scene has none.");
  inputs.cloth.uv = &sheet.stretch;
  const auto disagree = Offscreen::create(fixture.device(), frontal(View::Textured), inputs);
  REQUIRE_FALSE(disagree);
  CHECK(disagree.error().kind == ErrorKind::Shape);
  inputs.cloth = sheet.draw();
  inputs.cloth.ranges[0].triangle_count += 1;
  const auto past = Offscreen::create(fixture.device(), frontal(View::Textured), inputs);
  REQUIRE_FALSE(past);
  CHECK(past.error().message == "A cloth's triangles end at 33, past the 32 of buffer triangles.");
  inputs.cloth = sheet.draw();
  Settings huge = frontal(View::Textured);
  huge.width = 1000000;
  CHECK(Offscreen::create(fixture.device(), huge, inputs).error().kind == ErrorKind::Limit);
}
