#pragma once

#include <vector>

#include "gpu/buffer.hpp"
#include "state/gpu_model.hpp"

namespace weft {

/// The triangles around each vertex for src/method/air.wgsl: vertex_count + 1 rows as places in the list itself, then
/// three words a triangle, its other corners and the bits of the vertex's share of it (AirTriangle).
/// Errors  Limit, OutOfMemory.
Result<gpu::Buffer<std::uint32_t>> air_corners(gpu::Device& device, const GpuModel& model);

}  // namespace weft
