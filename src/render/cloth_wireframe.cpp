#include "render/cloth_wireframe.hpp"

namespace weft::render {

Result<ClothWireframe> ClothWireframe::create(gpu::Device& device, const Look& look,
                                              const gpu::Buffer<FrameParams>& frame,
                                              std::span<const gpu::Buffer<FabricParams>> fabrics,
                                              const ClothDraw& cloth) {
  ClothWireframe made;
  WEFT_TRY(pipeline,
           gpu::RenderPipeline::create(device, "render/cloth_wireframe.wgsl", picture_pipeline(look)));
  made.pipeline_ = std::move(pipeline);
  for (const ClothRange& range : cloth.ranges) {
    const gpu::Buffer<FabricParams>& fabric = fabrics[made.parts_.size()];
    Part part;
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, made.pipeline_.bind(
                          {frame, fabric, *cloth.position[parity], *cloth.normal, *cloth.triangles}));
      part.groups[parity] = std::move(group);
    }
    part.first_vertex = 3 * range.first_triangle;
    part.vertex_count = 3 * range.triangle_count;
    made.parts_.push_back(std::move(part));
  }
  return made;
}

void ClothWireframe::record(gpu::RenderPass& pass, std::uint32_t parity) const {
  for (const Part& part : parts_)
    pass.draw(pipeline_.id(), part.groups[parity].id(), part.vertex_count, 1, part.first_vertex);
}

}  // namespace weft::render
