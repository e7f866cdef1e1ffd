// What lies over a picture: the triangles of a panel, as immediate-mode libraries hand them over.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.hpp"
#include "gpu/buffer.hpp"
#include "gpu/render_pipeline.hpp"
#include "gpu/texture.hpp"

namespace weft::overlay {

/// A corner of a triangle, as overlay.wgsl reads it.
struct Vertex {
  float x = 0, y = 0;       // [pixel], from the target's top left corner
  float u = 0, v = 0;       // place in the atlas, each from 0 to 1
  std::uint32_t color = 0;  // red in the lowest byte, alpha in the highest; sRGB
  std::uint32_t clip = 0;   // number of the rectangle outside of which nothing is drawn
};

/// As overlay.wgsl reads it.
struct Params {
  std::uint32_t width = 0, height = 0;              // of the target [pixel]
  std::uint32_t atlas_width = 0, atlas_height = 0;  // [texel]
};

/// As picture.wgsl reads it.
struct Place {
  std::uint32_t x = 0, y = 0;           // of the picture's top left corner in the target [pixel]
  std::uint32_t width = 0, height = 0;  // of the target [pixel]
};

/// Draws a picture into a target, and triangles over it. Colours are bytes of sRGB, of the picture, of the triangles
/// and of the target, and blend as such.
class Overlay {
 public:
  Overlay() = default;
  /// Reads   format: of the targets, rgba8unorm or bgra8unorm; atlas: atlas_width x atlas_height alphas, row by row,
  ///         atlas_width a multiple of 4. Triangles take the nearest texel's.
  /// Errors  Shape: the atlas has another size. Shader, OutOfMemory.
  static Result<Overlay> create(gpu::Device& device, gpu::TextureFormat format,
                                std::span<const std::uint8_t> atlas, std::uint32_t atlas_width,
                                std::uint32_t atlas_height);

  /// Draws this texture from now on, pixel by pixel, with its top left corner at (x, y) [pixel]. Errors  Shader.
  Result<void> set_picture(const gpu::Texture& picture, std::uint32_t x, std::uint32_t y);
  /// The triangles of the next pictures, three vertices each, in their order; clips: left, top, right, bottom [pixel].
  /// Errors  OutOfMemory, Limit.
  Result<void> set_triangles(std::span<const Vertex> vertices, std::span<const Vec4f> clips);
  /// Records one pass into a target of this size [pixel], whose place is not kept: the list serves until the next call
  /// of a function that is not const.
  void record(gpu::CommandList& list, gpu::Id target, std::uint32_t width, std::uint32_t height);

 private:
  Result<void> bind();

  gpu::Device* device_ = nullptr;
  gpu::RenderPipeline triangle_pipeline_, picture_pipeline_;
  gpu::Buffer<Params> params_;
  gpu::Buffer<Place> place_;
  gpu::Buffer<std::uint32_t> atlas_;
  gpu::Buffer<Vertex> vertices_;
  gpu::Buffer<Vec4f> clips_;
  gpu::BindGroup triangle_group_, picture_group_;
  Params shown_params_;
  Place shown_place_;
  std::uint32_t count_ = 0;  // vertices that are drawn
};

}  // namespace weft::overlay
