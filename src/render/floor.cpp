#include "render/floor.hpp"

#include <cmath>

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
          Vec4f::from(across.to<float>(), shadows_only ? 0.0F : 1.0F + static_cast<float>(plane.material))};
}

PlaneParams moved_plane(const PlaneParams& rest, const scene::RigidTransform& move, const Vec3d& middle) {
  const auto turned = [&](const Vec4f& v) { return move(v.xyz().to<double>()) - move.translation; };
  const Vec3d along = turned(rest.along), across = turned(rest.across);
  Vec3d center = move(rest.center.xyz().to<double>());
  const double period = 2 * static_cast<double>(rest.along.w);  // of the checker board [m]
  for (const Vec3d& axis : {along, across})
    center += std::round(dot(middle - center, axis) / period) * period * axis;
  return {Vec4f::from(center.to<float>(), rest.center.w), Vec4f::from(along.to<float>(), rest.along.w),
          Vec4f::from(across.to<float>(), rest.across.w)};
}

Result<std::vector<gpu::Buffer<PlaneParams>>> create_planes(gpu::Device& device,
                                                            const std::vector<PlaneParams>& planes) {
  std::vector<gpu::Buffer<PlaneParams>> buffers;
  for (const PlaneParams& params : planes) {
    WEFT_TRY(buffer, gpu::create_uniform(device, params, "plane"));
    buffers.push_back(std::move(buffer));
  }
  return buffers;
}

Result<Floors> Floors::create(gpu::Device& device, const char* shader, gpu::RenderPipelineInfo info,
                              std::size_t planes) {
  Floors made;
  if (planes == 0) return made;
  info.cull = gpu::CullMode::Back;  // from below, a floor does not hide the scene
  WEFT_SET(made.pipeline_, gpu::RenderPipeline::create(device, shader, info));
  made.groups_.resize(planes);
  return made;
}

Result<void> Floors::bind(std::size_t plane, std::initializer_list<gpu::Binding> sources) {
  WEFT_SET(groups_[plane], pipeline_.bind(sources));
  return {};
}

void Floors::record(gpu::RenderPass& pass) const {
  for (const gpu::BindGroup& group : groups_) pass.draw(pipeline_.id(), group.id(), 6);
}

}  // namespace weft::render
