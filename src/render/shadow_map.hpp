#pragma once

#include <array>

#include "render/frame_params.hpp"
#include "render/inputs.hpp"
#include "render/object_draws.hpp"

namespace weft::render {

/// Depth as the sun sees it, of all cloths and obstacles.
class ShadowMap {
 public:
  static constexpr std::uint32_t kTexels = 2048;  // a side

  ShadowMap() = default;
  /// Errors  Limit: the adapter's textures are smaller than kTexels.
  static Result<ShadowMap> create(gpu::Device& device, const gpu::Buffer<FrameParams>& frame,
                                  const ClothDraw& cloth, const ObjectBuffers& objects);
  void record(gpu::CommandList& list, std::uint32_t parity) const;

  gpu::BindingSource texture() const { return depth_.source(); }
  gpu::BindingSource sampler() const { return sampler_.source(); }

 private:
  gpu::Texture depth_;
  gpu::Sampler sampler_;
  gpu::RenderPipeline cloth_pipeline_;
  std::array<gpu::BindGroup, 2> cloth_;  // by parity
  ObjectDraws objects_;
  gpu::Id cloth_indices_ = 0;
  std::uint32_t cloth_index_count_ = 0;
};

}  // namespace weft::render
