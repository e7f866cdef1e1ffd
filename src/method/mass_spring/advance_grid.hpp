#pragma once

#include <vector>

#include "element/spring/spring_grid.hpp"
#include "gpu/dispatch.hpp"
#include "method/equal_cloths.hpp"
#include "method/solver.hpp"

namespace weft {

/// One substep of equal grid cloths: forces gathered per node, then semi-implicit Euler.
/// Source  docs/solvers/mass_spring.md.
/// Reads   steps, motions; position[parity] [m], velocity[parity] [m/s], rest_position [m].
/// Writes  position[1 - parity], velocity[1 - parity] of the cloths' vertices.
/// Errors  Shader, OutOfMemory.
class AdvanceGrid {
 public:
  static Result<AdvanceGrid> create(const SolverInputs& inputs, const EqualCloths& cloths);
  void record(gpu::ComputePass& pass) const { dispatch_.record(pass); }

 private:
  gpu::RawBuffer grid_;
  gpu::Dispatch dispatch_;
};

/// The overrides of a kernel for this body: terms that it lacks are not computed.
std::vector<gpu::Constant> grid_constants(const Body& body);
Result<gpu::Buffer<SpringGrid>> grid_uniform(gpu::Device& device, const Body& body);
/// A kernel that advances grids, with the bindings that all of them have.
Result<gpu::Dispatch> grid_dispatch(const SolverInputs& inputs, const gpu::SharedKernel& kernel,
                                    const gpu::Workgroups& workgroups, const gpu::RawBuffer& grid);

}  // namespace weft
