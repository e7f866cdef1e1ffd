#pragma once

#include "method/multigrid/cycle.hpp"

namespace weft {

/// The kernels of grids, shared by all of them. Those of the finest level recompute its matrix from the
/// nodes' positions; the others read that of their level. Source: docs/solvers/multigrid.md.
struct GridKernels {
  gpu::SharedKernel predict, gradient;                          // the linear system
  gpu::SharedKernel galerkin_fine, galerkin;                    // matrices of coarse levels
  gpu::SharedKernel smooth_fine, residual_fine;                 // the cycle on the finest level, down
  gpu::SharedKernel correct_fine, prolong_fine, finish;         // and up
  gpu::SharedKernel smooth_down, residual, prolong, smooth_up;  // on those between
  gpu::SharedKernel restrict_residual;                          // from level to level
  gpu::SharedKernel cycle_tail;                                 // on the coarsest

  /// Errors  Shader.
  static Result<GridKernels> create(const CycleInputs& inputs);
};

/// The kernels of meshes: the same for all levels.
struct MeshKernels {
  gpu::SharedKernel predict, gradient, galerkin;               // the linear system, and its coarse levels
  gpu::SharedKernel smooth_down, residual, restrict_residual;  // the cycle: down
  gpu::SharedKernel tail;                                      // on the coarsest levels
  gpu::SharedKernel prolong, smooth_begin, smooth_up, finish;  // up

  /// Errors  Shader.
  static Result<MeshKernels> create(const CycleInputs& inputs);
};

}  // namespace weft
