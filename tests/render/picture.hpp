// Queries of tests on a picture.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <set>

#include "picture/image.hpp"

namespace weft {

/// The mean of red, green and blue, 0 to 255, over a square of `2 * reach + 1` pixels around a place in [0,
/// 1]^2.
inline double brightness(const picture::Image& image, double u, double v, int reach = 2) {
  const int x = static_cast<int>(u * image.width), y = static_cast<int>(v * image.height);
  double sum = 0;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      for (int channel = 0; channel < 3; ++channel)
        sum += image.pixel(static_cast<std::uint32_t>(x + dx), static_cast<std::uint32_t>(y + dy))[channel];
  return sum / (3 * (2 * reach + 1) * (2 * reach + 1));
}

inline std::size_t color_count(const picture::Image& image) {
  std::set<std::uint32_t> colors;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    colors.insert(std::uint32_t{image.rgba[i]} << 16U | std::uint32_t{image.rgba[i + 1]} << 8U |
                  image.rgba[i + 2]);
  return colors.size();
}

/// Pixels of which a channel differs by more than `tolerance`.
inline std::size_t difference(const picture::Image& a, const picture::Image& b, int tolerance = 0) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 4; ++channel)
      largest = std::max(largest, std::abs(int{a.rgba[i + channel]} - int{b.rgba[i + channel]}));
    count += largest > tolerance ? 1 : 0;
  }
  return count;
}

}  // namespace weft
