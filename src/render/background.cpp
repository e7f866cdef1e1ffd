#include "render/background.hpp"

namespace weft::render {

Result<Background> Background::create(gpu::Device& device, const Look& look,
                                      const gpu::Buffer<FrameParams>& frame,
                                      const gpu::Buffer<LightParams>& light) {
  Background made;
  gpu::RenderPipelineInfo info = picture_pipeline(look);
  info.depth_write = false;
  info.depth_or_equal = true;  // it lies at depth 1, to which depth is cleared
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/background.wgsl", info));
  made.pipeline_ = std::move(pipeline);
  WEFT_TRY(group, made.pipeline_.bind({frame, light}));
  made.group_ = std::move(group);
  return made;
}

}  // namespace weft::render
