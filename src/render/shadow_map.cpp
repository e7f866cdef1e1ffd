#include "render/shadow_map.hpp"

#include "render/object_surface.hpp"
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
  WEFT_TRY(open, gpu::RenderPipeline::create(device, "render/depth.wgsl", info));
  made.open_ = std::move(open);
  info.cull = gpu::CullMode::Back;
  WEFT_TRY(closed, gpu::RenderPipeline::create(device, "render/depth.wgsl", info));
  made.closed_ = std::move(closed);
  WEFT_TRY(closed_object, made.closed_.bind({frame, objects.position, objects.placement}));
  made.closed_object_ = std::move(closed_object);
  WEFT_TRY(open_object, made.open_.bind({frame, objects.position, objects.placement}));
  made.open_object_ = std::move(open_object);
  if (objects.moving_index_count > 0) {
    info.cull = gpu::CullMode::None;
    info.constants = {{"kMoves", 1}};
    WEFT_TRY(moving, gpu::RenderPipeline::create(device, "render/depth.wgsl", info));
    made.moving_ = std::move(moving);
    WEFT_TRY(moving_object, made.moving_.bind({frame, objects.position, objects.placement}));
    made.moving_object_ = std::move(moving_object);
  }
  made.object_indices_ = objects.indices.id();
  made.closed_index_count_ = objects.closed_index_count;
  made.open_index_count_ = objects.open_index_count;
  made.moving_index_count_ = objects.moving_index_count;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, made.open_.bind({frame, *cloth.position[parity], objects.placement}));
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
  pass.draw_indexed(closed_.id(), closed_object_.id(), object_indices_, closed_index_count_);
  pass.draw_indexed(open_.id(), open_object_.id(), object_indices_, open_index_count_, closed_index_count_);
  pass.draw_indexed(moving_.id(), moving_object_.id(), object_indices_, moving_index_count_,
                    closed_index_count_ + open_index_count_);
  pass.draw_indexed(open_.id(), cloth_[parity].id(), cloth_indices_, cloth_index_count_);
}

}  // namespace weft::render
