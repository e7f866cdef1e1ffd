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
  Vec4f right;        // half the picture's width at a distance of 1; w: where depth begins [m]
  Vec4f up;           // half its height there; w: where depth ends [m]
  Vec4f forward;      // unit; w: how far things keep the sky from each other [m]
  Vec4f shadow_span;  // width, height and depth of the shadow map [m]
};
static_assert(sizeof(FrameParams) == 400);
static_assert(offsetof(FrameParams, eye) == 128 && offsetof(FrameParams, color_map) == 192);

}  // namespace weft::render
