#pragma once

#include <array>

#include "gpu/render_pipeline.hpp"
#include "gpu/texture.hpp"
#include "render/floor.hpp"
#include "render/light.hpp"
#include "render/object_draws.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

/// How much of the sun and the sky arrives at what the eye sees, at half the picture's size.
class SoftLight {
 public:
  SoftLight() = default;
  /// Errors  Shader.
  static Result<SoftLight> create(gpu::Device& device, const gpu::Buffer<FrameParams>& frame,
                                  const ClothDraw& cloth, const ObjectBuffers& objects,
                                  std::span<const gpu::Buffer<PlaneParams>> planes);
  /// Reads  width, height: of the picture [pixel].
  /// Errors  Limit, OutOfMemory; what was before stays then.
  Result<void> resize(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                      const gpu::Buffer<FrameParams>& frame, const gpu::Buffer<LightParams>& light,
                      const ShadowMap& shadow);
  void record(gpu::CommandList& list, std::uint32_t parity) const;

  gpu::BindingSource depth() const { return depth_.source(); }
  gpu::BindingSource arriving() const { return smooth_.source(); }  // red: of the sky, green: of the sun

 private:
  gpu::RenderPipeline cloth_pipeline_, arriving_pipeline_, smooth_pipeline_;
  std::array<gpu::BindGroup, 2> cloth_;  // by parity
  gpu::Id cloth_indices_ = 0;
  std::uint32_t cloth_index_count_ = 0;
  ObjectDraws objects_;
  Floors floors_;
  gpu::Texture depth_, arriving_, smooth_;
  gpu::BindGroup arriving_group_, smooth_group_;
};

}  // namespace weft::render
