#pragma once

#include "gpu/types.hpp"
#include "scene/scene.hpp"

namespace weft::render {

inline constexpr std::uint32_t kSamples = 4;
inline constexpr auto kColorFormat = gpu::TextureFormat::Rgba8UnormSrgb;
inline constexpr auto kDepthFormat = gpu::TextureFormat::Depth32Float;

/// What every pipeline that draws into the picture has in common.
inline gpu::RenderPipelineInfo picture_pipeline(scene::View view) {
  gpu::RenderPipelineInfo info;
  info.color = kColorFormat;
  info.depth = kDepthFormat;
  info.samples = kSamples;
  info.constants = {{"kView", static_cast<double>(view)}};
  return info;
}

}  // namespace weft::render
