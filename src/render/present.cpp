#include "render/present.hpp"

namespace weft::render {

gpu::TextureFormat srgb_format(gpu::TextureFormat format) {
  return format == gpu::TextureFormat::Rgba8Unorm   ? gpu::TextureFormat::Rgba8UnormSrgb
         : format == gpu::TextureFormat::Bgra8Unorm ? gpu::TextureFormat::Bgra8UnormSrgb
                                                    : format;
}

Result<Present> Present::create(gpu::Device& device, gpu::TextureFormat format, std::uint32_t width,
                                std::uint32_t height) {
  Present made;
  made.device_ = &device;
  made.picture_format_ = srgb_format(format);
  gpu::RenderPipelineInfo info;
  info.color = format;
  info.constants = {{"kEncode", format == made.picture_format_ ? 0.0 : 1.0}};
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/present.wgsl", info));
  made.pipeline_ = std::move(pipeline);
  WEFT_CHECK(made.resize(width, height));
  return made;
}

Result<void> Present::resize(std::uint32_t width, std::uint32_t height) {
  WEFT_TRY(picture, gpu::Texture::create(
                        *device_, {width, height, 1, picture_format_, gpu::kRenderTarget | gpu::kSampled},
                        "presented picture"));
  WEFT_TRY(group, pipeline_.bind({picture.source()}));
  picture_ = std::move(picture);
  group_ = std::move(group);
  return {};
}

void Present::record(gpu::CommandList& list, gpu::Id target) const {
  gpu::RenderPass pass(list, {target, 0, 0, {0, 0, 0, 1}, false}, "present");
  pass.draw(pipeline_.id(), group_.id(), 3);
}

}  // namespace weft::render
