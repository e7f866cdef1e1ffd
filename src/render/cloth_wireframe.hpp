#pragma once

#include <array>
#include <vector>

#include <span>

#include "gpu/render_pipeline.hpp"
#include "render/fabric.hpp"
#include "render/frame_params.hpp"
#include "render/picture_pipeline.hpp"

namespace weft::render {

/// Draws all cloths as the edges of their triangles on a quiet sheet.
class ClothWireframe {
 public:
  ClothWireframe() = default;
  static Result<ClothWireframe> create(gpu::Device& device, const Look& look,
                                       const gpu::Buffer<FrameParams>& frame,
                                       std::span<const gpu::Buffer<FabricParams>> fabrics,
                                       const ClothDraw& cloth);
  void record(gpu::RenderPass& pass, std::uint32_t parity) const;

 private:
  struct Part {
    std::array<gpu::BindGroup, 2> groups;  // by parity
    std::uint32_t first_vertex = 0, vertex_count = 0;
  };
  gpu::RenderPipeline pipeline_;
  std::vector<Part> parts_;
};

}  // namespace weft::render
