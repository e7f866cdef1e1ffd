#include "render/cloth_wireframe.hpp"

#include "render/picture_pipeline.hpp"

namespace weft::render {

Result<ClothWireframe> ClothWireframe::create(gpu::Device& device, const gpu::Buffer<FrameParams>& frame,
                                              const ClothDraw& cloth) {
  ClothWireframe made;
  const gpu::RenderPipelineInfo info = picture_pipeline(scene::View::Wireframe);
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/cloth_wireframe.wgsl", info));
  made.pipeline_ = std::move(pipeline);
  for (const ClothRange& range : cloth.ranges) {
    Part part;
    WEFT_TRY(weave, create_weave(device, range, made.parts_.size()));
    part.weave = std::move(weave);
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, made.pipeline_.bind(
                          {frame, part.weave, *cloth.position[parity], *cloth.normal, *cloth.triangles}));
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
