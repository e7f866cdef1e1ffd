#include "picture/stroke_font.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace weft::picture {
namespace {

// Strokes as corners "xy" on a grid of 4 by 6, top left 00; a comma lifts the pen.
//   00 10 20 30 40
//   ..          ..
//   06 16 26 36 46
struct Glyph {
  char letter;
  int width;
  const char* strokes;
};
constexpr Glyph kGlyphs[] = {
    {'0', 4, "10 30 41 45 36 16 05 01 10"},
    {'1', 4, "11 20 26,16 36"},
    {'2', 4, "01 10 30 41 42 06 46"},
    {'3', 4, "01 10 30 41 42 33 44 45 36 16 05,13 33"},
    {'4', 4, "36 30 04 44"},
    {'5', 4, "40 00 03 12 32 43 45 36 16 05"},
    {'6', 4, "41 30 10 01 05 16 36 45 44 33 13 04"},
    {'7', 4, "00 40 16"},
    {'8', 4, "13 02 01 10 30 41 42 33 13 04 05 16 36 45 44 33"},
    {'9', 4, "05 16 36 45 41 30 10 01 02 13 33 42"},
    {'.', 0, "06 06"},
    {'-', 4, "03 43"},
    {'+', 4, "03 43,21 25"},
    {'%', 4, "40 06,00 10 11 01 00,35 45 46 36 35"},
    {'s', 3, "32 12 03 14 24 35 26 06"},
    {'t', 3, "10 15 26 36,02 32"},
    {'r', 3, "02 06,03 12 32"},
    {'e', 4, "04 44 43 32 12 03 05 16 36"},
    {'c', 4, "43 32 12 03 05 16 36 45"},
    {'h', 4, "00 06,03 12 32 43 46"},
    {'p', 4, "02 06,03 12 32 43 44 35 15 04"},
    {'d', 4, "40 46,43 32 12 03 05 16 36 45"},
    {'o', 4, "12 32 43 45 36 16 05 03 12"},
    {'n', 4, "02 06,03 12 32 43 46"},
    {'a', 4, "12 32 43 46,44 14 05 16 36 45"},
    {'m', 4, "02 06,03 12 23 26,23 32 43 46"},
    {'/', 3, "30 06"},
};
constexpr float kGap = 1.6F;   // grid units between letters
constexpr float kPen = 0.42F;  // grid units, the pen's radius
constexpr float kGridHeight = 6;

const Glyph* find(char letter) {
  const auto* glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                   [&](const Glyph& g) { return g.letter == letter; });
  return glyph == std::end(kGlyphs) ? nullptr : glyph;
}

float distance_to_segment(float x, float y, const float* a, const float* b) {
  const float dx = b[0] - a[0], dy = b[1] - a[1];
  const float square = dx * dx + dy * dy;
  const float along = square > 0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / square, 0.0F, 1.0F) : 0;
  return std::hypot(x - a[0] - along * dx, y - a[1] - along * dy);
}

/// The distance of a point of the grid to the nearest stroke.
float distance_to_strokes(const char* strokes, float x, float y) {
  float nearest = 1e9F;
  for (const char* s = strokes; std::strlen(s) >= 5; s += 3) {
    if (s[2] == ',') continue;
    const float a[] = {static_cast<float>(s[0] - '0'), static_cast<float>(s[1] - '0')};
    const float b[] = {static_cast<float>(s[3] - '0'), static_cast<float>(s[4] - '0')};
    nearest = std::min(nearest, distance_to_segment(x, y, a, b));
  }
  return nearest;
}

}  // namespace

void blend(Image& image, int x, int y, Color color, float share) {
  if (x < 0 || y < 0 || x >= static_cast<int>(image.width) || y >= static_cast<int>(image.height)) return;
  std::uint8_t* pixel = image.pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  const std::uint8_t over[] = {color.red, color.green, color.blue};
  for (int i = 0; i < 3; ++i)
    pixel[i] =
        static_cast<std::uint8_t>(std::lround(pixel[i] + share * static_cast<float>(over[i] - pixel[i])));
}

float text_width(const std::string& text, float height) {
  float units = 0;
  for (const char letter : text) {
    const Glyph* glyph = find(letter);
    units += static_cast<float>(glyph != nullptr ? glyph->width : 2) + kGap;
  }
  return std::max(0.0F, units - kGap) * height / kGridHeight;
}

void draw_text(Image& image, float x, float y, float height, const std::string& text, Color color) {
  const float unit = height / kGridHeight;
  for (const char letter : text) {
    const Glyph* glyph = find(letter);
    const float width = static_cast<float>(glyph != nullptr ? glyph->width : 2);
    if (glyph != nullptr) {
      const int left = static_cast<int>(std::floor(x - unit)), top = static_cast<int>(std::floor(y - unit));
      const int right = static_cast<int>(std::ceil(x + (width + 1) * unit));
      const int bottom = static_cast<int>(std::ceil(y + height + unit));
      for (int py = top; py <= bottom; ++py)
        for (int px = left; px <= right; ++px) {
          const float gx = (static_cast<float>(px) + 0.5F - x) / unit,
                      gy = (static_cast<float>(py) + 0.5F - y) / unit;
          const float cover = (kPen - distance_to_strokes(glyph->strokes, gx, gy)) * unit + 0.5F;
          if (cover > 0) blend(image, px, py, color, std::min(cover, 1.0F));
        }
    }
    x += (width + kGap) * unit;
  }
}

}  // namespace weft::picture
