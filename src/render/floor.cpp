#include "render/floor.hpp"

#include <cmath>

#include "render/picture_pipeline.hpp"

namespace weft::render {

PlaneParams plane_params(const scene::ColliderPlane& plane, const Vec3d& middle, double reach,
                         bool shadows_only) {
  const Vec3d normal = plane.normal / length(plane.normal);
  const Vec3d center = middle - dot(normal, middle - plane.point) * normal;
  const Vec3d helper = std::abs(normal.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
  const Vec3d across = cross(normal, helper) / length(cross(normal, helper));
  const Vec3d along = cross(across, normal);  // along x across = normal
  const double square = std::exp2(std::round(std::log2(reach / 24)));
  return {Vec4f::from(center.to<float>(), static_cast<float>(reach)),
          Vec4f::from(along.to<float>(), static_cast<float>(square)),
          Vec4f::from(across.to<float>(), shadows_only ? 0.0F : 1.0F)};
}

Result<Floor> Floor::create(gpu::Device& device, scene::View view, const gpu::Buffer<FrameParams>& frame,
                            const ShadowMap& shadow, const PlaneParams& params) {
  Floor made;
  WEFT_TRY(buffer, gpu::Buffer<PlaneParams>::create_from(device, {&params, 1}, "plane",
                                                         gpu::kUniform | gpu::kCopyTarget));
  made.params_ = std::move(buffer);
  gpu::RenderPipelineInfo info = picture_pipeline(view);
  info.cull = gpu::CullMode::Back;  // from below, a floor does not hide the scene
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/floor.wgsl", info));
  made.pipeline_ = std::move(pipeline);
  WEFT_TRY(group, made.pipeline_.bind({frame, shadow.texture(), shadow.sampler(), made.params_}));
  made.group_ = std::move(group);
  return made;
}

}  // namespace weft::render
