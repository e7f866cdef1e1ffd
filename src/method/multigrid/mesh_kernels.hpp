#pragma once

#include "gpu/kernel.hpp"

namespace weft {

/// The kernels of the multigrid solver for cloths that are meshes, one for all of them. Source:
/// docs/solvers/multigrid.md.
struct MeshKernels {
  gpu::Kernel predict, gradient, galerkin;               // the linear system, and its coarse levels
  gpu::Kernel smooth_down, residual, restrict_residual;  // the cycle: down
  gpu::Kernel tail;                                      // on the coarsest levels
  gpu::Kernel prolong, smooth_begin, smooth_up, finish;  // up

  /// `holds`: whether contact may hold nodes at obstacles. Errors  Shader.
  static Result<MeshKernels> create(gpu::Device& device, bool holds, std::uint32_t workgroup_size);
};

}  // namespace weft
