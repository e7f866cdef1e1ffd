// Where a V-cycle ends. From level to level a node has more mass, and no more stiffness; where inertia is a good part
// of a level's matrix, some sweeps solve there what coarser levels would.
// Source: docs/solvers/multigrid.md, equation 8a.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "method/multigrid/mesh_levels.hpp"
#include "method/multigrid/smoothing.hpp"
#include "model/model.hpp"

namespace weft::multigrid {

/// At the coarsest level: the lower end where nothing better is known, and the sweeps for that.
inline constexpr double kBottomLow = kSmoothHigh / 30;
inline constexpr std::uint32_t kBottomSweeps = 10;
/// By what the sweeps of a bottom that has inertia make each part of the error smaller, at least. What is left of the
/// cloth's motion as a whole is momentum: with 10 a free mesh loses 0.3 % of it, with 30 0.12 %.
inline constexpr double kBottomPart = 100;
/// The cycle on levels of no more nodes is done by one workgroup, so that 16 KiB of its memory are enough: of a grid
/// (src/method/multigrid/cycle_tail.wgsl) and of a mesh (mesh_tail.wgsl).
inline constexpr std::uint32_t kGridTail = 682, kMeshTail = 554;
/// The same of fabric and of tetrahedra, whose blocks are larger: of fabric one workgroup reads those of 504 nodes in
/// twice the time that six dispatches take.
inline constexpr std::uint32_t kElementTail = 320;

/// What a level is like: its nodes, and of one of them the inertia and the stiffness in its matrix's diagonal [N/m].
struct LevelScale {
  std::uint32_t nodes = 0;
  double inertia = 0, stiffness = 0;
};

/// The last level of a cycle, and how it is solved. By default the coarsest that there is.
struct Bottom {
  std::size_t level = std::numeric_limits<std::size_t>::max();
  std::uint32_t sweeps = kBottomSweeps;
  double low = kBottomLow;  // the lower end of the eigenvalues that they are for
};

/// The levels of a cloth for substeps of `step` [s], the finest first. `levels`: those of mesh_levels.
std::vector<LevelScale> grid_scales(const Model& model, const Body& body, double step);
std::vector<LevelScale> mesh_scales(const Model& model, const SystemBodies& bodies,
                                    std::span<const MeshLevel> levels, double step);

/// How much a node's part of a residual's norm counts: of several bodies each has a norm of weight as large as the
/// largest then, so that none is left unsolved beside another. By nodes of all `bodies`, which have volume.
std::vector<float> norm_scales(const Model& model, const SystemBodies& bodies, double step);

/// Where one workgroup, which does the levels of no more than `most` nodes, has least to do.
Bottom bottom_of(std::span<const LevelScale> levels, std::uint32_t most);

}  // namespace weft::multigrid
