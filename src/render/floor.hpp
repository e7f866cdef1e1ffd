#pragma once

#include <initializer_list>
#include <vector>

#include "gpu/render_pipeline.hpp"
#include "render/picture_pipeline.hpp"
#include "render/shadow_map.hpp"
#include "scene/motion.hpp"

namespace weft::render {

/// Mirror of Plane in src/render/floor.wgsl.
struct PlaneParams {
  Vec4f center;  // [m]; w: half the side [m]
  Vec4f along;   // unit; w: a checker square's side [m]
  Vec4f across;  // unit; w: 1 + its material, 0 for one that is seen only by the shadows on it
};
/// The part of a plane under what is drawn: around the point nearest to `middle`, `reach` [m] to each side.
PlaneParams plane_params(const scene::ColliderPlane& plane, const Vec3d& middle, double reach,
                         bool shadows_only);

/// A plane that has moved, seen around the point nearest to `middle`: its squares move with it.
PlaneParams moved_plane(const PlaneParams& rest, const scene::RigidTransform& move, const Vec3d& middle);

Result<std::vector<gpu::Buffer<PlaneParams>>> create_planes(gpu::Device& device,
                                                            const std::vector<PlaneParams>& planes);

/// Draws planes that fade into the background.
class Floors {
 public:
  Floors() = default;
  /// Reads  planes: how many; with none there is no pipeline.
  static Result<Floors> create(gpu::Device& device, const char* shader, gpu::RenderPipelineInfo info,
                               std::size_t planes);
  /// The inputs of one plane, as the shader's bindings are numbered.
  Result<void> bind(std::size_t plane, std::initializer_list<gpu::Binding> sources);
  void record(gpu::RenderPass& pass) const;

 private:
  gpu::RenderPipeline pipeline_;
  std::vector<gpu::BindGroup> groups_;  // one a plane
};

}  // namespace weft::render
