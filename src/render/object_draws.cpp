#include "render/object_draws.hpp"

namespace weft::render {

Result<ObjectBuffers> ObjectBuffers::create(gpu::Device& device, const ObjectMesh& mesh) {
  WEFT_TRY(position, gpu::Buffer<Vec4f>::create_from(device, mesh.positions, "object position"));
  WEFT_TRY(normal, gpu::Buffer<Vec4f>::create_from(device, mesh.normals, "object normal"));
  WEFT_TRY(indices, gpu::Buffer<std::uint32_t>::create_from(device, mesh.indices, "object triangles",
                                                            gpu::kIndex | gpu::kCopyTarget));
  WEFT_TRY(placement, gpu::Buffer<Vec4f>::create(device, 3 * mesh.moving.size(), "object placement"));
  return ObjectBuffers{std::move(position), std::move(normal), std::move(indices), std::move(placement),
                       mesh.groups};
}

Result<ObjectDraws> ObjectDraws::create(gpu::Device& device, const char* shader,
                                        const gpu::RenderPipelineInfo& info, const ObjectBuffers& buffers) {
  ObjectDraws made;
  made.index_buffer_ = buffers.indices.id();
  for (const ObjectGroup& group : buffers.groups) {
    if (group.index_count == 0) continue;
    gpu::RenderPipelineInfo own = info;
    if (group.closed) own.cull = gpu::CullMode::Back;
    if (group.moves) own.constants.push_back({"kMoves", 1});
    WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, shader, own));
    made.draws_.push_back({std::move(pipeline), {}, group});
  }
  return made;
}

Result<void> ObjectDraws::bind(std::initializer_list<gpu::Binding> sources) {
  for (Draw& draw : draws_) WEFT_SET(draw.bound, draw.pipeline.bind(sources));
  return {};
}

void ObjectDraws::record(gpu::RenderPass& pass) const {
  for (const auto& [pipeline, bound, group] : draws_)
    pass.draw_indexed(pipeline.id(), bound.id(), index_buffer_, group.index_count, group.first_index);
}

}  // namespace weft::render
