#pragma once

#include "method/multigrid/cycle.hpp"
#include "method/multigrid/mesh_levels.hpp"

namespace weft {

/// Whether a grid has bend springs: then all grids' kernels look for some.
bool any_bend_springs(const Model& model);

/// The kernels of grids and meshes alike: the system, conjugate gradients, the new state.
struct SharedKernels {
  gpu::SharedKernel predict, finish, begin_anew;
  gpu::SharedKernel begin_solve, advance;
  gpu::SharedKernel go_on, predict_again, begin_again;  // systems behind the first
  gpu::SharedKernel first_norm, square, norm, rho;      // add_up.wgsl for each sum
  gpu::SharedKernel first_norm_again, last_norm, begin_measure, measure;
  gpu::SharedKernel pair_force, pair_product, pair_end, pair_finish;  // of pairs that are held apart
  gpu::SharedKernel pair_force_again;
  gpu::SharedKernel add_gas;                 // none without gas
  gpu::SharedKernel add_air, add_air_again;  // none without air

  /// `finest`: the smoothing of the finest level. Errors  Shader.
  static Result<SharedKernels> create(const CycleInputs& inputs, multigrid::CycleKind kind,
                                      const multigrid::Smoothing& finest);
};

/// The kernels of grids, shared by all of them. Those of the finest level recompute its matrix from the
/// nodes' positions; the others read that of their level. Source: docs/solvers/multigrid.md.
struct GridKernels {
  SharedKernels shared;
  multigrid::Smoothing smoothing;                             // of the finest level
  gpu::SharedKernel gradient;                                 // the linear system
  gpu::SharedKernel galerkin_fine, galerkin;                  // matrices of coarse levels
  gpu::SharedKernel smooth_fine, residual_fine;               // the cycle on the finest level, down
  gpu::SharedKernel correct_fine, prolong_fine, smooth_last;  // and up
  gpu::SharedKernel search;                                   // A p
  gpu::SharedKernel restrict_residual;                        // from there to the next level
  gpu::SharedKernel descend, ascend;                          // on those between
  gpu::SharedKernel cycle_tail;                               // on the coarsest

  /// Errors  Shader.
  static Result<GridKernels> create(const CycleInputs& inputs);
};

/// The kernels of a cloth of fabric's own elements.
struct FabricKernels {
  gpu::SharedKernel membranes, hinges, forces, blocks;
  gpu::SharedKernel cords;  // none where nothing is limited or sewn
};

/// The kernels of a body with volume's own elements.
struct SolidKernels {
  gpu::SharedKernel terms, blocks;
};

/// The sweeps of a level: down behind the first one, which other kernels do; up all, but the finest level's last.
struct LevelSmoothing {
  std::vector<gpu::SharedKernel> down, up;
};

/// The kernels of meshes of one kind of elements: the same for all levels. All but springs have general blocks.
struct MeshKernels {
  SharedKernels shared;
  FabricKernels fabric;                  // none but for fabric
  SolidKernels solid;                    // none but for tetrahedra
  gpu::SharedKernel gradient, galerkin;  // the linear system, and its coarse levels
  multigrid::Smoothing smoothing;        // of the finest level
  LevelSmoothing finest, coarse;
  gpu::SharedKernel residual, restrict_residual, prolong;  // the cycle: down and up
  gpu::SharedKernel tail, tail_of_pieces;                  // on the coarsest levels
  gpu::SharedKernel smooth_last;                           // the last sweep on the finest
  gpu::SharedKernel search;                                // A p

  /// Errors  Shader.
  static Result<MeshKernels> create(const CycleInputs& inputs, multigrid::CycleKind kind);
};

}  // namespace weft
