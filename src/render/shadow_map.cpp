#include "render/shadow_map.hpp"

#include "render/picture_pipeline.hpp"

namespace weft::render {

Result<ShadowMap> ShadowMap::create(gpu::Device& device, const gpu::Buffer<FrameParams>& frame,
                                    const ClothDraw& cloth, const ObjectBuffers& objects) {
  ShadowMap made;
  const gpu::TextureInfo texture = {kTexels, kTexels, 1, kDepthFormat, gpu::kRenderTarget | gpu::kSampled};
  WEFT_TRY(depth, gpu::Texture::create(device, texture, "shadow map"));
  made.depth_ = std::move(depth);
  WEFT_TRY(sampler, gpu::Sampler::create(device, {.linear = true, .comparison = true}, "shadow map"));
  made.sampler_ = std::move(sampler);

  gpu::RenderPipelineInfo info;
  info.depth = kDepthFormat;
  info.fragment_entry.clear();
  info.depth_bias_slope = 1.5F;  // the receiver is lifted too (lighting.wgsl)
  WEFT_TRY(drawn, ObjectDraws::create(device, "render/depth.wgsl", info, objects));
  made.objects_ = std::move(drawn);
  WEFT_CHECK(made.objects_.bind({frame, objects.position, objects.placement}));
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/depth.wgsl", info));
  made.cloth_pipeline_ = std::move(pipeline);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.cloth_pipeline_.bind({frame, *cloth.position[parity], objects.placement}));
    made.cloth_[parity] = std::move(group);
  }
  made.cloth_indices_ = cloth.triangles->id();
  made.cloth_index_count_ = static_cast<std::uint32_t>(cloth.triangles->bytes() / sizeof(std::uint32_t));
  return made;
}

void ShadowMap::record(gpu::CommandList& list, std::uint32_t parity) const {
  gpu::RenderTarget target;
  target.depth = depth_.view();
  target.store_depth = true;
  gpu::RenderPass pass(list, target, "shadow map");
  objects_.record(pass);
  pass.draw_indexed(cloth_pipeline_.id(), cloth_[parity].id(), cloth_indices_, cloth_index_count_);
}

}  // namespace weft::render
