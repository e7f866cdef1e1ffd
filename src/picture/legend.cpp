#include "picture/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "picture/stroke_font.hpp"
#include "render/color_map.hpp"

namespace weft::picture {
namespace {

constexpr Color kInk = {38, 42, 48};
constexpr Color kPaper = {250, 250, 248};
constexpr int kSmallest = 120;  // pixels a side

void fill(Image& image, const Rectangle& area, Color color, float share) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) blend(image, x, y, color, share);
}

int rounded(float value) { return static_cast<int>(std::lround(value)); }

}  // namespace

//   +---------------+   The bar is 40 % of the picture's height; all else follows from the text's height.
//   | stretch       |
//   | [##] -- 1.15  |
//   | [##] -- 1.10  |
//   +---------------+
LegendLayout legend_layout(std::uint32_t width, std::uint32_t height, const render::Field& field) {
  LegendLayout layout;
  const float tall = static_cast<float>(height);
  const float text = std::max(8.0F, tall / 48);
  const float label_width = text_width("0.00", text);
  layout.text_height = text;
  const int pad = rounded(text);
  const int bar_width = rounded(1.2F * text), tick = rounded(0.9F * text), bar_height = rounded(0.4F * tall);
  const int content_width =
      std::max(bar_width + tick + rounded(label_width), rounded(text_width(field.title, text)));
  const int panel_width = content_width + 2 * pad;
  const int panel_height = bar_height + rounded(2.5F * text) + 2 * pad;
  layout.panel = {static_cast<int>(width) - panel_width - pad, (static_cast<int>(height) - panel_height) / 2,
                  panel_width, panel_height};
  layout.title = {layout.panel.x + pad, layout.panel.y + pad, panel_width - 2 * pad, rounded(text)};
  layout.bar = {layout.panel.x + pad, layout.title.y + rounded(2.2F * text), bar_width, bar_height};
  for (int i = 0; i < kLegendLabels; ++i)
    layout.labels.push_back({layout.bar.x + bar_width + tick,
                             layout.bar.y + i * (bar_height - 1) / (kLegendLabels - 1) - rounded(text / 2),
                             rounded(label_width) + 1, rounded(text)});
  return layout;
}

void draw_legend(Image& image, const render::Field& field) {
  if (image.width < kSmallest || image.height < kSmallest) return;
  const LegendLayout layout = legend_layout(image.width, image.height, field);
  const Rectangle& bar = layout.bar;
  fill(image, layout.panel, kPaper, 0.72F);
  draw_text(image, static_cast<float>(layout.title.x), static_cast<float>(layout.title.y), layout.text_height,
            field.title, kInk);
  for (int row = 0; row < bar.height; ++row) {
    const Vec3f color =
        255.0F * render::map_color(1 - static_cast<float>(row) / static_cast<float>(bar.height - 1));
    fill(image, {bar.x, bar.y + row, bar.width, 1},
         {static_cast<std::uint8_t>(std::lround(color.x)), static_cast<std::uint8_t>(std::lround(color.y)),
          static_cast<std::uint8_t>(std::lround(color.z))},
         1);
  }
  for (int i = 0; i < kLegendLabels; ++i) {
    const Rectangle& label = layout.labels[static_cast<std::size_t>(i)];
    char number[32];
    const auto [lowest, highest] = field.range;
    std::snprintf(number, sizeof number, "%.*f", field.decimals,
                  highest - (highest - lowest) * i / (kLegendLabels - 1));
    fill(image, {bar.x + bar.width, bar.y + i * (bar.height - 1) / (kLegendLabels - 1), bar.width / 3, 1},
         kInk, 1);
    draw_text(image, static_cast<float>(label.x), static_cast<float>(label.y), layout.text_height, number,
              kInk);
  }
}

}  // namespace weft::picture
