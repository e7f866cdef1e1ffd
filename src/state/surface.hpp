#pragma once

#include <cstdint>
#include <vector>

#include "gpu/dispatch.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Mirror of SurfaceParams in src/state/surface.wgsl.
struct SurfaceParams {
  std::uint32_t first_vertex = 0, vertex_count = 0, row = 0;
  std::uint32_t padding = 0;  // to a multiple of 16 bytes
};

/// The normal and the stretch of every vertex, and how many tetrahedra are flattened, once a frame: for drawing and for
/// the summary.
/// Reads   position[parity], rest_position [m]; triangles.
/// Writes  normal: vertex_count x Vec4f, unit; stretch: vertex_count x f32, length / rest length of the most
/// stretched
///         edge at the vertex; statistics.max_stretch, flattened.
/// Errors  Shader, Limit, OutOfMemory.
class Surface {
 public:
  static Result<Surface> create(gpu::Device& device, const GpuModel& model, const State& state);
  void record(gpu::ComputePass& pass) const;  ///< of the state in position[pass.parity()]

  const gpu::Buffer<Vec4f>& normal() const { return normal_; }
  const gpu::Buffer<float>& stretch() const { return stretch_; }

 private:
  Result<void> create_pattern(gpu::Device& device, const Model& model);
  Result<void> create_flattened(gpu::Device& device, const GpuModel& model, const State& state);

  struct ClothPart {
    gpu::RawBuffer params;
    bool cut_from_pattern = false;
    std::array<gpu::BindGroup, 2> groups;  // by the parity of the buffer that holds the state
    std::uint32_t vertex_count = 0;
  };
  gpu::Kernel kernel_;
  gpu::Kernel pattern_kernel_;  // of what is sewn, where anything is
  gpu::Buffer<Vec4f> pattern_;  // of each corner of each triangle its place in the pattern [m]
  gpu::Buffer<Vec4f> normal_;
  gpu::Buffer<float> stretch_;
  gpu::Buffer<std::uint32_t> offsets_, around_;
  std::vector<ClothPart> parts_;
  // Of all bodies; nothing where there is none.
  gpu::Buffer<std::array<std::uint32_t, 4>> tets_;
  gpu::Dispatch flattened_;
};

}  // namespace weft
