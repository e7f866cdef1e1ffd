#pragma once

#include <array>

#include "gpu/render_pipeline.hpp"
#include "gpu/texture.hpp"
#include "render/frame_params.hpp"
#include "render/inputs.hpp"

namespace weft::render {

struct ObjectBuffers;

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
  gpu::RenderPipeline closed_, open_, moving_;  // the first leaves out what faces away from the sun
  gpu::BindGroup closed_object_, open_object_, moving_object_;
  std::array<gpu::BindGroup, 2> cloth_;  // by parity
  gpu::Id object_indices_ = 0, cloth_indices_ = 0;
  std::uint32_t closed_index_count_ = 0, open_index_count_ = 0, moving_index_count_ = 0,
                cloth_index_count_ = 0;
};

}  // namespace weft::render
