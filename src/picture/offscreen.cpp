#include "picture/offscreen.hpp"

#include "picture/legend.hpp"

namespace weft::picture {

Result<Offscreen> Offscreen::create(gpu::Device& device, const render::Settings& settings,
                                    const render::Inputs& inputs, bool legend) {
  Offscreen made;
  made.device_ = &device;
  if (legend) made.legend_ = render::field_of(settings.view);
  if (made.legend_ && settings.range) made.legend_->range = *settings.range;
  WEFT_TRY(renderer, render::Renderer::create(device, settings, inputs));
  made.renderer_ = std::move(renderer);
  const gpu::TextureInfo resolved = {settings.width, settings.height, 1, settings.color_format,
                                     gpu::kRenderTarget | gpu::kTextureCopySource};
  WEFT_TRY(texture, gpu::Texture::create(device, resolved, "picture"));
  made.resolved_ = std::move(texture);
  WEFT_TRY(ring, ImageRing::create(device, settings.width, settings.height));
  made.ring_ = std::move(ring);
  return made;
}

void Offscreen::record(gpu::CommandList& list, std::uint32_t parity) const {
  renderer_.record(list, parity, resolved_.view());
  ring_.record(list, resolved_);
}

void Offscreen::finish(Image& image) const {
  if (legend_) draw_legend(image, *legend_);
}

Result<std::optional<Image>> Offscreen::try_take() {
  WEFT_TRY(image, ring_.try_take());
  if (image) finish(*image);
  return image;
}

Result<Image> Offscreen::read() {
  WEFT_TRY(image, ring_.take());
  finish(image);
  return image;
}

Result<Image> Offscreen::draw(std::uint32_t parity) {
  gpu::CommandList list;
  record(list, parity);
  WEFT_CHECK(device_->submit(list));
  start();
  return read();
}

}  // namespace weft::picture
