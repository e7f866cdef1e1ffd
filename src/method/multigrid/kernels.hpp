#pragma once

#include "gpu/kernel.hpp"

namespace weft {

/// The kernels of the multigrid solver, one for all cloths. Those of the finest level make its matrix anew
/// from where the nodes are; the others read that of their level. Source: docs/solvers/multigrid.md.
struct MultigridKernels {
  gpu::Kernel predict, gradient;                          // the linear system
  gpu::Kernel galerkin_fine, galerkin;                    // matrices of coarse levels
  gpu::Kernel smooth_fine, residual_fine;                 // the cycle on the finest level, down
  gpu::Kernel correct_fine, prolong_fine, finish;         // and up
  gpu::Kernel smooth_down, residual, prolong, smooth_up;  // on those between
  gpu::Kernel restrict_residual;                          // from level to level
  gpu::Kernel cycle_tail;                                 // on the coarsest

  /// `holds`: whether contact may hold nodes at obstacles. Errors  Shader.
  static Result<MultigridKernels> create(gpu::Device& device, bool holds, std::uint32_t workgroup_size);
};

}  // namespace weft
