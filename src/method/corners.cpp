#include "method/corners.hpp"

#include <cstring>
#include <vector>

namespace weft {

Result<gpu::Buffer<std::uint32_t>> corners_around(gpu::Device& device, std::size_t vertex_count,
                                                  std::span<const AirTriangle> triangles) {
  constexpr std::uint32_t kWords = 3;  // of a triangle at a vertex
  std::vector<std::uint32_t> list(vertex_count + 1);
  for (const AirTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners) list[corner + 1] += kWords;
  list[0] = static_cast<std::uint32_t>(list.size());
  for (std::size_t row = 1; row <= vertex_count; ++row) list[row] += list[row - 1];
  std::vector<std::uint32_t> next = list;  // where the next triangle of each vertex goes
  list.resize(list[vertex_count]);
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

Result<gpu::Buffer<std::uint32_t>> air_corners(gpu::Device& device, const Model& model) {
  return corners_around(device, model.vertex_count(), air_triangles(model));
}

}  // namespace weft
