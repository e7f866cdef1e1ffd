#pragma once

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/object.hpp"

namespace weft::gpu {

/// A texture that the caller of weft made, to draw into. Native only.
class GivenTexture {
 public:
  /// Reads   texture: a WGPUTexture of the device; a reference is held for as long as this lives.
  /// Errors  Input: the handle is null, or the texture is none that can be drawn into: two-dimensional, one layer,
  ///         one mip level, one sample a pixel, usage RenderAttachment, a format of rgba8unorm or bgra8unorm.
  static Result<GivenTexture> create(Device& device, Id texture);

  Id view() const { return view_.id(); }
  const TextureInfo& info() const { return info_; }

 private:
  GivenTexture(Object texture, TextureInfo info) : texture_(std::move(texture)), info_(info) {}

  Object texture_, view_;
  TextureInfo info_;
};

}  // namespace weft::gpu
