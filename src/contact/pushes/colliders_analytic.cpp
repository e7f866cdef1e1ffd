#include "contact/pushes/colliders_analytic.hpp"

#include <cmath>
#include <vector>

namespace weft::contact {

Result<CollidersAnalytic> CollidersAnalytic::create(gpu::Device& device, const State& state,
                                                    const Contacts& contacts,
                                                    std::span<const scene::ColliderSphere> spheres,
                                                    std::span<const scene::ColliderPlane> planes,
                                                    std::uint32_t workgroup_size) {
  std::vector<AnalyticCollider> list;
  for (const scene::ColliderSphere& sphere : spheres) {
    if (!(sphere.radius > 0))
      return input_error("Collider sphere %zu has the radius %g m, which is not positive.", list.size(),
                         sphere.radius);
    list.push_back({Vec4f::from(sphere.center.to<float>(), static_cast<float>(sphere.radius)), {}});
  }
  for (const scene::ColliderPlane& plane : planes) {
    if (!(std::abs(length(plane.normal) - 1) < 1e-6))
      return input_error("Collider plane %zu has a normal of length %g, which is not 1.",
                         list.size() - spheres.size(), length(plane.normal));
    const Vec3d normal =
        plane.normal / length(plane.normal);  // as near to 1 as f32 allows: push_scale counts on it
    list.push_back({Vec4f::from(plane.point.to<float>(), 0), Vec4f::from(normal.to<float>(), 1)});
  }
  CollidersAnalytic analytic;
  analytic.vertex_count_ = state.position[0].size();
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/pushes/analytic.wgsl", {}, workgroup_size));
  analytic.kernel_ = std::move(kernel);
  WEFT_TRY(colliders, gpu::Buffer<AnalyticCollider>::create_from(device, list, "analytic colliders"));
  analytic.colliders_ = std::move(colliders);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, analytic.kernel_.bind({state.steps, state.position[1 - parity], state.position[parity],
                                           analytic.colliders_, contacts.pushes, state.statistics}));
    analytic.groups_[parity] = std::move(group);
  }
  return analytic;
}

void CollidersAnalytic::record(gpu::ComputePass& pass) const {
  kernel_.dispatch(pass, groups_[pass.parity()], vertex_count_);
}

}  // namespace weft::contact
