#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft {

/// A picture: rows from top to bottom, each pixel red, green, blue, alpha, in sRGB.
struct Image {
  std::uint32_t width = 0, height = 0;  // [pixel]
  std::vector<std::uint8_t> rgba;       // 4 * width * height

  std::uint8_t* pixel(std::uint32_t x, std::uint32_t y) { return &rgba[4 * (std::size_t{y} * width + x)]; }
  const std::uint8_t* pixel(std::uint32_t x, std::uint32_t y) const {
    return &rgba[4 * (std::size_t{y} * width + x)];
  }
};

}  // namespace weft
