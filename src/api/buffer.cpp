#include <algorithm>

#include "api/running_world.hpp"
#include "gpu/readback.hpp"
#include "weft/world.hpp"

namespace weft {

std::size_t Buffer::count() const { return world_->world().model().vertex_count(); }
std::size_t Buffer::width() const { return quantity_ == Quantity::Stretch ? 1 : 3; }

Result<void> Buffer::read(std::span<float> values) const {
  const std::size_t size = count() * width();
  if (values.size() != size)
    return shape_error("A buffer of %zu x %zu floats does not fit %zu values.", count(), width(),
                       values.size());
  WEFT_CHECK(world_->settle());
  sim::World& world = world_->world();
  if (quantity_ == Quantity::Stretch) {
    WEFT_TRY(stretch, gpu::download(world.device(), world.surface().stretch()));
    std::copy(stretch.begin(), stretch.end(), values.begin());
    return {};
  }
  const auto& source = quantity_ == Quantity::Position   ? world.state().position[world.parity()]
                       : quantity_ == Quantity::Velocity ? world.state().velocity[world.parity()]
                                                         : world.surface().normal();
  WEFT_TRY(vectors, gpu::download(world.device(), source));
  auto value = values.begin();
  for (const Vec4f& v : vectors) {
    *value++ = v.x;
    *value++ = v.y;
    *value++ = v.z;
  }
  return {};
}

Result<void> Buffer::read(std::span<Vec3f> values) const {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  if (width() != 3) return shape_error("A buffer of %zu float an element holds no vectors.", width());
  return read(std::span(&values.data()->x, 3 * values.size()));
}

}  // namespace weft
