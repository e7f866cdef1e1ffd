#pragma once

#include <array>
#include <span>
#include <vector>

#include "gpu/render_pipeline.hpp"
#include "render/inputs.hpp"
#include "render/picture_pipeline.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

/// Mirror of Weave in src/render/weave.wgsl.
struct WeaveParams {
  Vec4f base, dark, accent, back;
};
/// The check of cloth number `index`, woven from its colour or from a palette's.
WeaveParams weave_of(const ClothRange& range, std::size_t index);
/// The weave of each cloth.
Result<std::vector<gpu::Buffer<WeaveParams>>> create_weaves(gpu::Device& device,
                                                            const std::vector<ClothRange>& ranges);

/// Draws the triangles of all cloths, woven, or coloured by normal or by a field.
class ClothSurface {
 public:
  ClothSurface() = default;
  static Result<ClothSurface> create(gpu::Device& device, const Look& look,
                                     const gpu::Buffer<FrameParams>& frame, const ShadowMap& shadow,
                                     std::span<const gpu::Buffer<WeaveParams>> weaves,
                                     const ClothDraw& cloth);
  void record(gpu::RenderPass& pass, std::uint32_t parity) const;

 private:
  struct Part {
    std::array<gpu::BindGroup, 2> groups;  // by parity
    std::uint32_t first_index = 0, index_count = 0;
  };
  gpu::RenderPipeline pipeline_;
  std::vector<Part> parts_;
  gpu::Id index_buffer_ = 0;
};

}  // namespace weft::render
