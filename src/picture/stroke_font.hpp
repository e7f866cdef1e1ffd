// Text as strokes of a round pen, so that one small table serves every size.
#pragma once

#include <string>

#include "picture/image.hpp"

namespace weft::picture {

struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// Blends a colour over a pixel; outside the image nothing happens.
void blend(Image& image, int x, int y, Color color, float share);

/// The width of a text whose digits are `height` tall [pixel].
float text_width(const std::string& text, float height);

/// Draws a text with its top left corner at (x, y) [pixel]. Known are digits, ".", "-", "+", "%", "/" and
/// the letters of the titles in render/field.cpp; anything else is a gap.
void draw_text(Image& image, float x, float y, float height, const std::string& text, Color color);

}  // namespace weft::picture
