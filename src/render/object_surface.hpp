#pragma once

#include "gpu/render_pipeline.hpp"
#include "render/object_mesh.hpp"
#include "render/picture_pipeline.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

/// The obstacles on the GPU. They do not move, so they are uploaded once.
struct ObjectBuffers {
  gpu::Buffer<Vec4f> position, normal;                         // vertex_count, m and unit
  gpu::Buffer<std::uint32_t> indices;                          // 3 * triangle_count
  std::uint32_t closed_index_count = 0, open_index_count = 0;  // the closed ones come first

  /// Errors  Limit, OutOfMemory.
  static Result<ObjectBuffers> create(gpu::Device& device, const ObjectMesh& mesh);
};

/// Draws the obstacles, lit.
class ObjectSurface {
 public:
  ObjectSurface() = default;
  static Result<ObjectSurface> create(gpu::Device& device, const Look& look,
                                      const gpu::Buffer<FrameParams>& frame, const ShadowMap& shadow,
                                      const ObjectBuffers& buffers);
  void record(gpu::RenderPass& pass) const;

 private:
  gpu::RenderPipeline closed_, open_;  // the first leaves out the far sides: half the work
  gpu::BindGroup closed_group_, open_group_;
  gpu::Id index_buffer_ = 0;
  std::uint32_t closed_index_count_ = 0, open_index_count_ = 0;
};

}  // namespace weft::render
