#include "render/color_map.hpp"

#include <algorithm>
#include <cmath>

namespace weft::render {

float srgb_to_linear(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float linear_to_srgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

Vec3f srgb_to_linear(const Vec3f& encoded) {
  return {srgb_to_linear(encoded.x), srgb_to_linear(encoded.y), srgb_to_linear(encoded.z)};
}

Vec3f map_color(float value) {
  const float place = std::clamp(value, 0.0F, 1.0F) * static_cast<float>(kColorMapSize - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColorMapSize - 2);
  const float share = place - static_cast<float>(below);
  const Vec3f mixed =
      (1 - share) * srgb_to_linear(kColorMap[below]) + share * srgb_to_linear(kColorMap[below + 1]);
  return {linear_to_srgb(mixed.x), linear_to_srgb(mixed.y), linear_to_srgb(mixed.z)};
}

}  // namespace weft::render
