#pragma once

#include "element/spring/spring_blocks.hpp"
#include "gpu/dispatch.hpp"
#include "state/state.hpp"

namespace weft {

/// Adds the force of every spring to its two nodes, to the same integers as SpringForces: a workgroup sums
/// the springs of a block in its own memory first.
/// Source  docs/solvers/mass_spring.md, "Sums in workgroup memory".
/// Reads   steps; position[parity] [m], velocity[parity] [m/s]: vertex_count x Vec4f.
/// Writes  force, as SpringForces.
/// Errors  Shader, OutOfMemory. Limit: build_spring_blocks.
class SpringBlockForces {
 public:
  static Result<SpringBlockForces> create(gpu::Device& device, const GpuModel& model, const State& state,
                                          const Springs& springs, const gpu::Buffer<std::int32_t>& force,
                                          std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::Buffer<SpringBlock> blocks_;
  gpu::Buffer<std::uint32_t> nodes_;
  gpu::Buffer<BlockSpring> springs_;
  gpu::Buffer<SpringKind> kinds_;
  gpu::Dispatch dispatch_;
};

}  // namespace weft
