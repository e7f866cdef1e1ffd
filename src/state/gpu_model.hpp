#pragma once

#include <array>
#include <cstdint>

#include "gpu/buffer.hpp"
#include "model/model.hpp"

namespace weft {

/// The model on the GPU: the buffers that several rooms read.
struct GpuModel {
  Model host;
  gpu::Buffer<Vec4f> rest_position;      // vertex_count, m; w: Model::motion; of a grabbed node its GrabSlots
  gpu::Buffer<std::array<float, 2>> uv;  // vertex_count, m
  gpu::Buffer<std::uint32_t> triangles;  // 3 * triangle_count

  /// Errors  Limit, OutOfMemory.
  static Result<GpuModel> create(gpu::Device& device, Model host);
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(rest_position.size()); }
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles.size() / 3); }
};

}  // namespace weft
