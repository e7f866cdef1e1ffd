#pragma once

#include "gpu/render_pipeline.hpp"
#include "render/shadow_map.hpp"

namespace weft::render {

/// Mirror of Plane in shaders/render/floor.wgsl.
struct PlaneParams {
  Vec4f center;  // [m]; w: half the side [m]
  Vec4f along;   // unit; w: a checker square's side [m]
  Vec4f across;  // unit; w: 1 for a floor, 0 for one that is seen only by the shadows on it
};
/// The part of a plane under what is drawn: around the point nearest to `middle`, `reach` [m] to each side.
PlaneParams plane_params(const scene::ColliderPlane& plane, const Vec3d& middle, double reach,
                         bool shadows_only);

/// Draws a plane that fades into the background.
class Floor {
 public:
  Floor() = default;
  static Result<Floor> create(gpu::Device& device, scene::View view, const gpu::Buffer<FrameParams>& frame,
                              const ShadowMap& shadow, const PlaneParams& params);
  void record(gpu::RenderPass& pass) const { pass.draw(pipeline_.id(), group_.id(), 6); }

 private:
  gpu::Buffer<PlaneParams> params_;
  gpu::RenderPipeline pipeline_;
  gpu::BindGroup group_;
};

}  // namespace weft::render
