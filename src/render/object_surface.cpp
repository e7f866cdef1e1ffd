#include "render/object_surface.hpp"

namespace weft::render {

Result<ObjectBuffers> ObjectBuffers::create(gpu::Device& device, const ObjectMesh& mesh) {
  WEFT_TRY(position, gpu::Buffer<Vec4f>::create_from(device, mesh.positions, "object position"));
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create_from(device, mesh.normals, "object normal"));
  WEFT_TRY(indices, gpu::Buffer<std::uint32_t>::create_from(device, mesh.indices, "object triangles",
                                                            gpu::kIndex | gpu::kCopyTarget));
  WEFT_TRY(placement, gpu::Buffer<Vec4f>::create(device, 3 * mesh.moving.size(), "object placement"));
  const auto closed = static_cast<std::uint32_t>(mesh.closed_index_count);
  const auto open = static_cast<std::uint32_t>(mesh.open_index_count);
  const auto moving = static_cast<std::uint32_t>(mesh.indices.size()) - closed - open;
  return ObjectBuffers{
      std::move(position), std::move(normal), std::move(indices), std::move(placement), closed, open, moving};
}

Result<ObjectSurface> ObjectSurface::create(gpu::Device& device, const Look& look,
                                            const gpu::Buffer<FrameParams>& frame, const ShadowMap& shadow,
                                            const ObjectBuffers& buffers) {
  ObjectSurface made;
  made.index_buffer_ = buffers.indices.id();
  gpu::RenderPipelineInfo open = picture_pipeline(look), closed = open, moving = open;
  closed.cull = gpu::CullMode::Back;
  moving.constants.push_back({"kMoves", 1});
  const auto add = [&](Group& group, const gpu::RenderPipelineInfo& info, std::uint32_t first,
                       std::uint32_t count) -> Result<void> {
    WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/object.wgsl", info));
    WEFT_TRY(bound, pipeline.bind({frame, shadow.texture(), shadow.sampler(), buffers.position,
                                   buffers.normal, buffers.placement}));
    group = {std::move(pipeline), std::move(bound), first, count};
    return {};
  };
  WEFT_CHECK(add(made.closed_, closed, 0, buffers.closed_index_count));
  WEFT_CHECK(add(made.open_, open, buffers.closed_index_count, buffers.open_index_count));
  if (buffers.moving_index_count > 0)
    WEFT_CHECK(add(made.moving_, moving, buffers.first_moving_index(), buffers.moving_index_count));
  return made;
}

void ObjectSurface::record(gpu::RenderPass& pass) const {
  for (const Group* group : {&closed_, &open_, &moving_})
    pass.draw_indexed(group->pipeline.id(), group->bound.id(), index_buffer_, group->index_count,
                      group->first_index);
}

}  // namespace weft::render
