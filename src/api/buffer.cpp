#include <cstring>

#include "api/running_world.hpp"
#include "gpu/readback.hpp"
#include "weft/native.hpp"

namespace weft {

std::size_t Buffer::count() const { return world_->world().model().vertex_count(); }
std::size_t Buffer::width() const { return quantity_ == Quantity::Stretch ? 1 : 3; }

NativeBuffer Buffer::native() const {
  const std::uint64_t stride = quantity_ == Quantity::Stretch ? sizeof(float) : sizeof(Vec4f);
  return {reinterpret_cast<WGPUBuffer>(world_->buffer(quantity_).id()), 0, stride, count()};
}

Result<void> Buffer::read(std::span<float> values) const {
  const std::size_t nodes = count();
  if (values.size() != nodes * width())
    return shape_error("A buffer of %zu x %zu floats does not fit %zu values.", nodes, width(),
                       values.size());
  WEFT_CHECK(world_->settle());
  const std::uint64_t stride = native().stride;
  WEFT_TRY(bytes,
           gpu::download_bytes(world_->world().device(), world_->buffer(quantity_).range(0, nodes * stride)));
  for (std::size_t node = 0; node < nodes; ++node)
    std::memcpy(&values[node * width()], &bytes[node * stride], width() * sizeof(float));
  return {};
}

Result<void> Buffer::read(std::span<Vec3f> values) const {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  if (width() != 3) return shape_error("A buffer of %zu float an element holds no vectors.", width());
  return read(std::span(&values.data()->x, 3 * values.size()));
}

}  // namespace weft
