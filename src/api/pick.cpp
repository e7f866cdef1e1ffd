#include <algorithm>
#include <cmath>

#include "api/running_world.hpp"

namespace weft {
namespace {

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Of the cloths, which lie one after the other, the one that has a node.
std::uint32_t cloth_of(const Model& model, std::uint32_t node) {
  const auto next = std::upper_bound(model.bodies.begin(), model.bodies.end(), node,
                                     [](std::uint32_t n, const Body& c) { return n < c.first_vertex; });
  return static_cast<std::uint32_t>(next - model.bodies.begin()) - 1;
}

}  // namespace

Result<std::optional<Picked>> World::pick(const Ray& ray) {
  const double norm = length(ray.direction);
  if (!finite(ray.origin) || !std::isfinite(norm) || norm == 0)
    return input_error("A ray from (%g, %g, %g) along (%g, %g, %g) has no place or no direction.",
                       ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                       ray.direction.z);
  WEFT_CHECK(running_->settle());
  WEFT_CHECK(running_->session.take_snapshot());
  const Model& model = running_->world().model().host;
  const auto found = render::pick_node({ray.origin, ray.direction / norm},
                                       running_->session.snapshot().position, model.triangles);
  if (!found) return std::optional<Picked>();
  return std::optional<Picked>(
      {cloth_of(model, found->node), found->triangle, found->node, found->point, found->distance});
}

Result<std::optional<Picked>> World::pick(double x, double y, const PictureOptions& options) {
  WEFT_TRY(settings, running_->settings(options));
  const double width = settings.width, height = settings.height;
  if (!(x >= 0 && x <= width && y >= 0 && y <= height))
    return input_error("The place (%g, %g) is outside the picture of %u x %u pixels.", x, y, settings.width,
                       settings.height);
  const Camera camera = options.camera.value_or(render::camera_of(settings));
  return pick(render::pick_ray(camera, width / height, 2 * x / width - 1, 1 - 2 * y / height));
}

}  // namespace weft
