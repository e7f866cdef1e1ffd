#include "gpu/given_texture.hpp"

#include "gpu/native/context.hpp"

namespace weft::gpu {
namespace {

TextureFormat drawable_format(WGPUTextureFormat format) {
  switch (format) {
    case WGPUTextureFormat_RGBA8Unorm:
      return TextureFormat::Rgba8Unorm;
    case WGPUTextureFormat_RGBA8UnormSrgb:
      return TextureFormat::Rgba8UnormSrgb;
    case WGPUTextureFormat_BGRA8Unorm:
      return TextureFormat::Bgra8Unorm;
    case WGPUTextureFormat_BGRA8UnormSrgb:
      return TextureFormat::Bgra8UnormSrgb;
    default:
      return TextureFormat::None;
  }
}

/// What stands in the way of drawing into a texture: more than one of what there must be one of.
Result<void> check_single(const char* what, std::uint32_t count) {
  if (count == 1) return {};
  return input_error("A texture to draw into has one %s, and this one has %u.", what, count);
}

Result<TextureInfo> describe(WGPUTexture texture) {
  const WGPUTextureFormat format = wgpuTextureGetFormat(texture);
  TextureInfo info;
  info.format = drawable_format(format);
  if (info.format == TextureFormat::None)
    return input_error(
        "A texture to draw into is RGBA8Unorm, RGBA8UnormSrgb, BGRA8Unorm or BGRA8UnormSrgb, and this one "
        "has "
        "WGPUTextureFormat 0x%08x.",
        static_cast<unsigned>(format));
  const WGPUTextureDimension dimension = wgpuTextureGetDimension(texture);
  // What the descriptor had comes back; there Undefined stands for two.
  if (dimension != WGPUTextureDimension_2D && dimension != WGPUTextureDimension_Undefined)
    return input_error("A texture to draw into has two dimensions, and this one has not.");
  WEFT_CHECK(check_single("layer", wgpuTextureGetDepthOrArrayLayers(texture)));
  WEFT_CHECK(check_single("mip level", wgpuTextureGetMipLevelCount(texture)));
  WEFT_CHECK(check_single("sample a pixel", wgpuTextureGetSampleCount(texture)));
  if ((wgpuTextureGetUsage(texture) & WGPUTextureUsage_RenderAttachment) == 0)
    return input_error("A texture to draw into has the usage RenderAttachment, and this one has not.");
  info.width = wgpuTextureGetWidth(texture);
  info.height = wgpuTextureGetHeight(texture);
  info.usage = kRenderTarget;
  return info;
}

}  // namespace

Result<GivenTexture> GivenTexture::create(Device& device, Id texture) {
  if (texture == 0) return input_error("The handle of the texture to draw into is null.");
  const auto handle = backend::handle<WGPUTexture>(texture);
  WEFT_TRY(info, describe(handle));
  wgpuTextureAddRef(handle);
  GivenTexture made(Object(ObjectKind::Texture, texture), info);
  WEFT_TRY(view, backend::create_texture_view(device.context(), texture, "texture to draw into"));
  made.view_ = Object(ObjectKind::TextureView, view);
  return made;
}

}  // namespace weft::gpu
