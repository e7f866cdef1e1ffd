#include "method/air_corners.hpp"

#include <cstring>

#include "model/air_triangles.hpp"

namespace weft {

Result<gpu::Buffer<std::uint32_t>> air_corners(gpu::Device& device, const GpuModel& model) {
  constexpr std::uint32_t kWords = 3;  // of a triangle at a vertex
  const std::vector<AirTriangle> triangles = air_triangles(model.host);
  std::vector<std::uint32_t> list(model.vertex_count() + 1);
  for (const AirTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners) list[corner + 1] += kWords;
  list[0] = static_cast<std::uint32_t>(list.size());
  for (std::size_t row = 1; row <= model.vertex_count(); ++row) list[row] += list[row - 1];
  std::vector<std::uint32_t> next = list;  // where the next triangle of each vertex goes
  list.resize(list[model.vertex_count()]);
  for (const AirTriangle& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& at = next[triangle.corners[k]];
      list[at] = triangle.corners[(k + 1) % 3];
      list[at + 1] = triangle.corners[(k + 2) % 3];
      const auto share = static_cast<float>(triangle.shares[k]);
      std::memcpy(&list[at + 2], &share, sizeof share);  // libc++ 14 has no bit_cast
      at += kWords;
    }
  return gpu::Buffer<std::uint32_t>::create_from(device, list, "corners around");
}

}  // namespace weft
