#pragma once

#include "gpu/render_pipeline.hpp"
#include "render/frame_params.hpp"
#include "render/light.hpp"
#include "render/picture_pipeline.hpp"

namespace weft::render {

/// Fills what nothing else covers; drawn last, so that covered pixels cost nothing.
class Background {
 public:
  Background() = default;
  /// Reads  light: of the textured view, whose background may be a sky.
  static Result<Background> create(gpu::Device& device, const Look& look,
                                   const gpu::Buffer<FrameParams>& frame,
                                   const gpu::Buffer<LightParams>& light);
  void record(gpu::RenderPass& pass) const { pass.draw(pipeline_.id(), group_.id(), 3); }

 private:
  gpu::RenderPipeline pipeline_;
  gpu::BindGroup group_;
};

}  // namespace weft::render
