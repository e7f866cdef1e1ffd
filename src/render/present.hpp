#pragma once

#include "gpu/render_pipeline.hpp"
#include "gpu/texture.hpp"

namespace weft::render {

/// The format whose bytes are those of `format` and which encodes what is stored by sRGB's curve.
gpu::TextureFormat srgb_format(gpu::TextureFormat format);

/// A picture to draw into, and its way onto a canvas or into a texture of the host's. A renderer could resolve its
/// samples into the canvas's texture itself, but that is seen through an sRGB view of a format that is not sRGB, and
/// SwiftShader then leaves out the encoding: the picture comes out dark.
class Present {
 public:
  Present() = default;
  /// Reads   format: of the canvas; where it is not sRGB, the copy applies the curve.
  /// Errors  Limit, Shader, OutOfMemory.
  static Result<Present> create(gpu::Device& device, gpu::TextureFormat format, std::uint32_t width,
                                std::uint32_t height);
  Result<void> resize(std::uint32_t width, std::uint32_t height);

  /// The view to draw into: of srgb_format(format).
  gpu::Id picture() const { return picture_.view(); }
  /// Records the copy onto a view of the same format and size.
  void record(gpu::CommandList& list, gpu::Id target) const;

 private:
  gpu::Device* device_ = nullptr;
  gpu::TextureFormat picture_format_ = gpu::TextureFormat::None;
  gpu::Texture picture_;
  gpu::RenderPipeline pipeline_;
  gpu::BindGroup group_;
};

}  // namespace weft::render
