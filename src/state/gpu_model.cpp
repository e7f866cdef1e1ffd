#include "state/gpu_model.hpp"

namespace weft {

Result<GpuModel> GpuModel::create(gpu::Device& device, Model host) {
  GpuModel model;
  std::vector<Vec4f> rest(host.vertex_count());
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = Vec4f::from(host.rest_position[i].to<float>(), static_cast<float>(host.motion[i]));
  WEFT_TRY(rest_position, gpu::Buffer<Vec4f>::create_from(device, rest, "rest position"));
  model.rest_position = std::move(rest_position);
  WEFT_TRY(uv, (gpu::Buffer<std::array<float, 2>>::create_from(device, host.uv, "uv")));
  model.uv = std::move(uv);
  const std::span indices(host.triangles.data()->data(), 3 * host.triangles.size());
  WEFT_TRY(triangles, gpu::Buffer<std::uint32_t>::create_from(device, indices, "triangles",
                                                              gpu::kStorageDefault | gpu::kIndex));
  model.triangles = std::move(triangles);
  model.host = std::move(host);
  return model;
}

}  // namespace weft
