#pragma once

#include <span>

#include "gpu/buffer.hpp"
#include "model/air_triangles.hpp"

namespace weft {

/// The triangles around each vertex for src/method/corners.wgsl: vertex_count + 1 rows as places in the list itself,
/// then three words a triangle, its other corners and the bits of the vertex's share of it.
/// Errors  Limit, OutOfMemory.
Result<gpu::Buffer<std::uint32_t>> corners_around(gpu::Device& device, std::size_t vertex_count,
                                                  std::span<const AirTriangle> triangles);

/// Of all triangles that the air pushes on.
Result<gpu::Buffer<std::uint32_t>> air_corners(gpu::Device& device, const Model& model);

}  // namespace weft
