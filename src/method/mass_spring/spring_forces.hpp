#pragma once

#include "element/spring/packed_springs.hpp"
#include "gpu/dispatch.hpp"
#include "state/state.hpp"

namespace weft {

/// Adds the force of every spring to its two nodes.
/// Source  Sung et al., Algorithm 1.
/// Reads   steps; position[parity] [m], velocity[parity] [m/s]: vertex_count x Vec4f.
/// Writes  force [N * force_scale]: 3 * vertex_count x int32, all x, all y, all z; added to,
///         integrate_forces clears it.
/// Errors  Shader, OutOfMemory. Limit: pack_springs. Shape: force is not three times position.
class SpringForces {
 public:
  static Result<SpringForces> create(gpu::Device& device, const State& state, const Springs& springs,
                                     const gpu::Buffer<std::int32_t>& force, std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::Buffer<PackedSpring> springs_;
  gpu::Buffer<SpringKind> kinds_;
  gpu::Dispatch dispatch_;
};

}  // namespace weft
