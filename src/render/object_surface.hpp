#pragma once

#include "gpu/render_pipeline.hpp"
#include "render/object_mesh.hpp"
#include "render/picture_pipeline.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

/// The obstacles on the GPU, as ObjectMesh orders them. Still ones are uploaded once; see MovingObjects.
struct ObjectBuffers {
  gpu::Buffer<Vec4f> position, normal;  // vertex_count, m and unit
  gpu::Buffer<std::uint32_t> indices;   // 3 * triangle_count
  gpu::Buffer<Vec4f> placement;         // three rows for each that moves, see render/placement.wgsl
  std::uint32_t closed_index_count = 0, open_index_count = 0, moving_index_count = 0;

  std::uint32_t first_moving_index() const { return closed_index_count + open_index_count; }

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
  /// What is drawn with one pipeline.
  struct Group {
    gpu::RenderPipeline pipeline;
    gpu::BindGroup bound;
    std::uint32_t first_index = 0, index_count = 0;
  };
  Group closed_, open_, moving_;  // the first leaves out the far sides: half the work
  gpu::Id index_buffer_ = 0;
};

}  // namespace weft::render
