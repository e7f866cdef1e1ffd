#pragma once

#include "gpu/render_pipeline.hpp"
#include "gpu/texture.hpp"
#include "render/object_mesh.hpp"

namespace weft::render {

/// The obstacles on the GPU, as ObjectMesh orders them. Still ones are uploaded once; see MovingObjects.
struct ObjectBuffers {
  gpu::Buffer<Vec4f> position, normal;  // vertex_count, m and unit
  gpu::Buffer<std::uint32_t> indices;   // 3 * triangle_count
  gpu::Buffer<Vec4f> placement;         // three rows for each that moves, see render/placement.wgsl
  std::array<ObjectGroup, 4> groups;

  /// Errors  Limit, OutOfMemory.
  static Result<ObjectBuffers> create(gpu::Device& device, const ObjectMesh& mesh);
};

/// Draws the obstacles with one shader: a pipeline for each group that is there, without the far sides of
/// what is closed.
class ObjectDraws {
 public:
  ObjectDraws() = default;
  static Result<ObjectDraws> create(gpu::Device& device, const char* shader,
                                    const gpu::RenderPipelineInfo& info, const ObjectBuffers& buffers);
  /// Reads  `sources`, as the shader's bindings are numbered. Before the first record, and when one has been replaced.
  Result<void> bind(std::initializer_list<gpu::Binding> sources);
  void record(gpu::RenderPass& pass) const;

 private:
  struct Draw {
    gpu::RenderPipeline pipeline;
    gpu::BindGroup bound;
    ObjectGroup group;
  };
  std::vector<Draw> draws_;
  gpu::Id index_buffer_ = 0;
};

}  // namespace weft::render
