#pragma once

#include "gpu/types.hpp"
#include "scene/scene.hpp"

namespace weft::render {

inline constexpr std::uint32_t kSamples = 4;
inline constexpr auto kDepthFormat = gpu::TextureFormat::Depth32Float;

/// The parameters of the pipelines that draw into a picture.
struct Look {
  scene::View view = scene::View::Textured;
  gpu::TextureFormat color_format = gpu::TextureFormat::Rgba8UnormSrgb;
};

/// Shared by all of them.
inline gpu::RenderPipelineInfo picture_pipeline(const Look& look) {
  gpu::RenderPipelineInfo info;
  info.color = look.color_format;
  info.depth = kDepthFormat;
  info.samples = kSamples;
  info.constants = {{"kView", static_cast<double>(look.view)}};
  return info;
}

}  // namespace weft::render
