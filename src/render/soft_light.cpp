#include "render/soft_light.hpp"

#include "render/picture_pipeline.hpp"

namespace weft::render {

Result<SoftLight> SoftLight::create(gpu::Device& device, const gpu::Buffer<FrameParams>& frame,
                                    const ClothDraw& cloth, const ObjectBuffers& objects,
                                    std::span<const gpu::Buffer<PlaneParams>> planes) {
  SoftLight made;
  gpu::RenderPipelineInfo depth;
  depth.depth = kDepthFormat;
  depth.fragment_entry.clear();
  WEFT_TRY(drawn, ObjectDraws::create(device, "render/view_depth.wgsl", depth, objects));
  made.objects_ = std::move(drawn);
  WEFT_CHECK(made.objects_.bind({frame, objects.position, objects.placement}));
  WEFT_SET(made.cloth_pipeline_, gpu::RenderPipeline::create(device, "render/view_depth.wgsl", depth));
  for (std::size_t parity = 0; parity < 2; ++parity)
    WEFT_SET(made.cloth_[parity],
             made.cloth_pipeline_.bind({frame, *cloth.position[parity], objects.placement}));
  made.cloth_indices_ = cloth.triangles->id();
  made.cloth_index_count_ = static_cast<std::uint32_t>(cloth.triangles->bytes() / sizeof(std::uint32_t));
  WEFT_SET(made.floors_, Floors::create(device, "render/floor_depth.wgsl", depth, planes.size()));
  for (std::size_t k = 0; k < planes.size(); ++k) WEFT_CHECK(made.floors_.bind(k, {frame, planes[k]}));
  gpu::RenderPipelineInfo whole;
  whole.color = gpu::TextureFormat::Rgba8Unorm;
  WEFT_SET(made.arriving_pipeline_, gpu::RenderPipeline::create(device, "render/arriving_light.wgsl", whole));
  WEFT_SET(made.smooth_pipeline_, gpu::RenderPipeline::create(device, "render/smooth_light.wgsl", whole));
  return made;
}

Result<void> SoftLight::resize(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                               const gpu::Buffer<FrameParams>& frame, const gpu::Buffer<LightParams>& light,
                               const ShadowMap& shadow) {
  const std::uint32_t w = (width + 1) / 2, h = (height + 1) / 2, usage = gpu::kRenderTarget | gpu::kSampled;
  WEFT_TRY(depth, gpu::Texture::create(device, {w, h, 1, kDepthFormat, usage}, "depth seen"));
  WEFT_TRY(arriving,
           gpu::Texture::create(device, {w, h, 1, gpu::TextureFormat::Rgba8Unorm, usage}, "arriving light"));
  WEFT_TRY(smooth,
           gpu::Texture::create(device, {w, h, 1, gpu::TextureFormat::Rgba8Unorm, usage}, "smooth light"));
  WEFT_TRY(arriving_group,
           arriving_pipeline_.bind({frame, light, depth.source(), shadow.texture(), shadow.sampler()}));
  WEFT_TRY(smooth_group, smooth_pipeline_.bind({frame, depth.source(), arriving.source()}));
  depth_ = std::move(depth);
  arriving_ = std::move(arriving);
  smooth_ = std::move(smooth);
  arriving_group_ = std::move(arriving_group);
  smooth_group_ = std::move(smooth_group);
  return {};
}

void SoftLight::record(gpu::CommandList& list, std::uint32_t parity) const {
  {
    gpu::RenderTarget target;
    target.depth = depth_.view();
    target.store_depth = true;
    gpu::RenderPass pass(list, target, "depth seen");
    pass.draw_indexed(cloth_pipeline_.id(), cloth_[parity].id(), cloth_indices_, cloth_index_count_);
    objects_.record(pass);
    floors_.record(pass);
  }
  {
    gpu::RenderPass pass(list, {arriving_.view(), 0, 0, {1, 1, 0, 1}, false}, "arriving light");
    pass.draw(arriving_pipeline_.id(), arriving_group_.id(), 3);
  }
  gpu::RenderPass pass(list, {smooth_.view(), 0, 0, {1, 1, 0, 1}, false}, "smooth light");
  pass.draw(smooth_pipeline_.id(), smooth_group_.id(), 3);
}

}  // namespace weft::render
