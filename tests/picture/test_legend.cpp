#include <doctest/doctest.h>

#include <cmath>

#include "picture/legend.hpp"
#include "picture/stroke_font.hpp"
#include "render/color_map.hpp"

using namespace weft;
using namespace weft::picture;

namespace {

Image grey(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 200)};
}

/// Pixels in a rectangle that are nearly as dark as ink.
int ink(const Image& image, const Rectangle& area) {
  int count = 0;
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x)
      count += image.pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))[0] < 90;
  return count;
}

constexpr render::Field kStretch{"stretch", {0.95, 1.15}, 2};

}  // namespace

TEST_CASE("a legend has its bar, its title and five numbers where its layout says") {
  for (const auto& [width, height] : {std::pair{1280U, 720U}, {640U, 480U}, {301U, 257U}, {120U, 120U}}) {
    Image image = grey(width, height);
    draw_legend(image, kStretch);
    const LegendLayout layout = legend_layout(width, height, kStretch);
    CAPTURE(width);
    CHECK(layout.panel.x >= 0);
    CHECK(layout.panel.x + layout.panel.width <= static_cast<int>(width));
    CHECK(ink(image, layout.title) > 20);
    REQUIRE(layout.labels.size() == kLegendLabels);
    for (const Rectangle& label : layout.labels) {
      CHECK(ink(image, label) > 10);
      CHECK(label.x + label.width <= layout.panel.x + layout.panel.width);
    }
    for (int i = 0; i < 5; ++i) {  // the bar: yellow above, violet below
      const int y = layout.bar.y + i * (layout.bar.height - 1) / 4;
      const std::uint8_t* pixel =
          image.pixel(static_cast<std::uint32_t>(layout.bar.x + 1), static_cast<std::uint32_t>(y));
      const auto from_top = static_cast<float>(y - layout.bar.y) / static_cast<float>(layout.bar.height - 1);
      const Vec3f expected = 255.0F * render::map_color(1 - from_top);
      CHECK(std::abs(static_cast<float>(pixel[0]) - expected.x) <= 0.51F);
      CHECK(std::abs(static_cast<float>(pixel[2]) - expected.z) <= 0.51F);
    }
  }
}

TEST_CASE("a legend's numbers depend on its range, and a tiny picture has none") {
  Image one = grey(640, 480), other = grey(640, 480), tiny = grey(60, 60);
  draw_legend(one, kStretch);
  draw_legend(other, {"stretch", {0.90, 1.15}, 2});
  const LegendLayout layout = legend_layout(640, 480, kStretch);
  const auto same = [&](const Rectangle& area) {
    for (int y = area.y; y < area.y + area.height; ++y)
      for (int x = area.x; x < area.x + area.width; ++x)
        if (*one.pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) !=
            *other.pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)))
          return false;
    return true;
  };
  CHECK(same(layout.labels.front()));
  CHECK_FALSE(same(layout.labels.back()));
  draw_legend(tiny, kStretch);
  CHECK(tiny.rgba == grey(60, 60).rgba);
}

TEST_CASE("no two letters look alike, and text stays inside its width") {
  const std::string letters = "0123456789.-+%/strechpdonam";
  std::vector<Image> drawn;
  for (const char letter : letters) {
    Image image = grey(40, 40);
    draw_text(image, 10, 10, 20, std::string(1, letter), {});
    for (const Image& other : drawn) CHECK(other.rgba != image.rgba);
    CHECK(ink(image, {0, 0, 40, 40}) > 3);
    const int right = 10 + static_cast<int>(std::ceil(text_width(std::string(1, letter), 20) + 3));
    CHECK(ink(image, {right, 0, 40 - right, 40}) == 0);
    drawn.push_back(std::move(image));
  }
}

TEST_CASE("text over the rim of a picture is cut") {
  Image image = grey(20, 20);
  draw_text(image, -5, 12, 20, "88888", {});
  CHECK(ink(image, {0, 0, 20, 20}) > 0);
}

TEST_CASE("the colour map's brightness grows all the way") {
  double before = -1;
  for (int i = 0; i <= 100; ++i) {
    const Vec3f c = render::map_color(static_cast<float>(i) / 100);
    const double luminance = 0.2126 * render::srgb_to_linear(c.x) + 0.7152 * render::srgb_to_linear(c.y) +
                             0.0722 * render::srgb_to_linear(c.z);
    CHECK(luminance > before);
    before = luminance;
  }
}
