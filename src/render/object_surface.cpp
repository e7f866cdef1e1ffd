#include "render/object_surface.hpp"

namespace weft::render {

Result<ObjectBuffers> ObjectBuffers::create(gpu::Device& device, const ObjectMesh& mesh) {
  WEFT_TRY(position, gpu::Buffer<Vec4f>::create_from(device, mesh.positions, "object position"));
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create_from(device, mesh.normals, "object normal"));
  WEFT_TRY(indices, gpu::Buffer<std::uint32_t>::create_from(device, mesh.indices, "object triangles",
                                                            gpu::kIndex | gpu::kCopyTarget));
  const auto closed = static_cast<std::uint32_t>(mesh.closed_index_count);
  const auto open = static_cast<std::uint32_t>(mesh.indices.size()) - closed;
  return ObjectBuffers{std::move(position), std::move(normal), std::move(indices), closed, open};
}

Result<ObjectSurface> ObjectSurface::create(gpu::Device& device, const Look& look,
                                            const gpu::Buffer<FrameParams>& frame, const ShadowMap& shadow,
                                            const ObjectBuffers& buffers) {
  ObjectSurface made;
  gpu::RenderPipelineInfo info = picture_pipeline(look);
  WEFT_TRY(open, gpu::RenderPipeline::create(device, "render/object.wgsl", info));
  made.open_ = std::move(open);
  info.cull = gpu::CullMode::Back;
  WEFT_TRY(closed, gpu::RenderPipeline::create(device, "render/object.wgsl", info));
  made.closed_ = std::move(closed);
  for (auto [pipeline, group] :
       {std::pair{&made.open_, &made.open_group_}, {&made.closed_, &made.closed_group_}}) {
    WEFT_TRY(bound,
             pipeline->bind({frame, shadow.texture(), shadow.sampler(), buffers.position, buffers.normal}));
    *group = std::move(bound);
  }
  made.index_buffer_ = buffers.indices.id();
  made.closed_index_count_ = buffers.closed_index_count;
  made.open_index_count_ = buffers.open_index_count;
  return made;
}

void ObjectSurface::record(gpu::RenderPass& pass) const {
  pass.draw_indexed(closed_.id(), closed_group_.id(), index_buffer_, closed_index_count_);
  pass.draw_indexed(open_.id(), open_group_.id(), index_buffer_, open_index_count_, closed_index_count_);
}

}  // namespace weft::render
