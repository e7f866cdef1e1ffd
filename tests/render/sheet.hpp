// A cloth of any shape on the GPU, for pictures.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/gpu_fixture.hpp"
#include "render/object_mesh.hpp"
#include "render/renderer.hpp"

namespace weft {

template <class T>
T value_of(Result<T> result) {
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  return std::move(*result);
}

using Shape = std::function<Vec3d(double, double)>;  // a place on the sheet, each in [0, 1], to the world [m]

/// A sheet of `count` x `count` nodes. Seen against its normal, u runs to the right and v upwards.
struct Sheet {
  std::array<gpu::Buffer<Vec4f>, 2> position;
  gpu::Buffer<Vec4f> normal;
  gpu::Buffer<std::array<float, 2>> uv;
  gpu::Buffer<float> stretch;
  gpu::Buffer<Vec4f> velocity;  // upwards, in m/s the number that is `stretch`
  gpu::Buffer<std::uint32_t> triangles;
  mesh::TriangleMesh mesh;

  Sheet(gpu::Device& device, std::uint32_t count_, const Shape& shape, double size = 1,
        const Shape& next_shape = {})
      : count(count_) {
    mesh = mesh_of(count, shape);
    std::vector<std::array<float, 2>> places;
    std::vector<float> lengths;
    for (std::uint32_t j = 0; j < count; ++j)
      for (std::uint32_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1), v = static_cast<double>(j) / (count - 1);
        places.push_back({static_cast<float>(size * u), static_cast<float>(size * v)});
        const double h = 1e-3;
        lengths.push_back(static_cast<float>(length(shape(u + h, v) - shape(u - h, v)) / (2 * h * size)));
      }
    const std::vector<Vec4f> here = positions_of(mesh);
    position[0] = value_of(gpu::Buffer<Vec4f>::create_from(device, here, "position 0"));
    const std::vector<Vec4f> there = next_shape ? positions_of(mesh_of(count, next_shape)) : here;
    position[1] = value_of(gpu::Buffer<Vec4f>::create_from(device, there, "position 1"));
    std::vector<Vec4f> normals;
    for (const Vec3f& n : render::vertex_normals(mesh)) normals.push_back(Vec4f::from(n, 0));
    normal = value_of(gpu::Buffer<Vec4f>::create_from(device, normals, "normal"));
    uv = value_of(gpu::Buffer<std::array<float, 2>>::create_from(device, places, "uv"));
    stretch = value_of(gpu::Buffer<float>::create_from(device, lengths, "stretch"));
    std::vector<Vec4f> velocities;
    for (const float value : lengths) velocities.push_back({0, value, 0, 0});
    velocity = value_of(gpu::Buffer<Vec4f>::create_from(device, velocities, "velocity"));
    std::vector<std::uint32_t> indices;
    for (const auto& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    triangles = value_of(gpu::Buffer<std::uint32_t>::create_from(device, indices, "triangles",
                                                                 gpu::kStorageDefault | gpu::kIndex));
    sheet_size = size;
  }

  render::ClothDraw draw() const {
    render::ClothDraw cloth;
    cloth.position = {&position[0], &position[1]};
    cloth.normal = &normal;
    cloth.uv = &uv;
    cloth.stretch = &stretch;
    cloth.velocity = {&velocity, &velocity};
    cloth.contacts = &stretch;
    cloth.triangles = &triangles;
    cloth.ranges = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), std::nullopt, sheet_size,
                     render::ClothGrid{{count, count, sheet_size, sheet_size}, 0}}};
    return cloth;
  }

  double sheet_size = 1;
  std::uint32_t count = 0;  // of nodes a side

 private:
  static mesh::TriangleMesh mesh_of(std::uint32_t count, const Shape& shape) {
    mesh::TriangleMesh made;
    for (std::uint32_t j = 0; j < count; ++j)
      for (std::uint32_t i = 0; i < count; ++i)
        made.positions.push_back(
            shape(static_cast<double>(i) / (count - 1), static_cast<double>(j) / (count - 1)).to<float>());
    for (std::uint32_t j = 0; j + 1 < count; ++j)
      for (std::uint32_t i = 0; i + 1 < count; ++i) {
        const std::uint32_t a = j * count + i, b = a + 1, c = a + count, d = c + 1;
        made.triangles.push_back({a, b, d});
        made.triangles.push_back({a, d, c});
      }
    return made;
  }
  static std::vector<Vec4f> positions_of(const mesh::TriangleMesh& mesh) {
    std::vector<Vec4f> positions;
    for (const Vec3f& p : mesh.positions) positions.push_back(Vec4f::from(p, 1));
    return positions;
  }
};

}  // namespace weft
