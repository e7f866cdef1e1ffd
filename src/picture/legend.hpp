// The colour map's key, drawn into a picture on the host.
#pragma once

#include <vector>

#include "picture/image.hpp"
#include "render/field.hpp"

namespace weft::picture {

struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;  // [pixel]
};

/// Where a legend stands in a picture of this size.
struct LegendLayout {
  Rectangle panel, bar, title;
  std::vector<Rectangle> labels;  // from the highest value to the lowest
  float text_height = 0;          // [pixel]
};
inline constexpr int kLegendLabels = 5;
LegendLayout legend_layout(std::uint32_t width, std::uint32_t height, const render::Field& field);

/// Draws the colour bar over the field's range with numbers and its title. A picture too small for it stays
/// as it is.
void draw_legend(Image& image, const render::Field& field);

}  // namespace weft::picture
