#pragma once

#include <array>
#include <cstddef>

#include "base/vec.hpp"
#include "render/color_map.hpp"

namespace weft::render {

/// Mirror of Frame in src/render/frame.wgsl.
struct FrameParams {
  std::array<float, 16> view_projection{}, light_projection{};
  Vec4f eye;                                     // [m]
  Vec4f to_light;                                // unit; w: the side of a shadow-map texel [m]
  Vec4f viewport;                                // width, height [pixel] and their inverses
  Vec4f field_range;                             // lowest, highest, 1 / (highest - lowest)
  std::array<Vec4f, kColorMapSize> color_map{};  // linear
};
static_assert(sizeof(FrameParams) == 336);
static_assert(offsetof(FrameParams, eye) == 128 && offsetof(FrameParams, color_map) == 192);

}  // namespace weft::render
