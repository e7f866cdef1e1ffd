// Which solver a scene's "solver" object means. A new solver is one line in each function of registry.cpp.
#pragma once

#include "solver/solver.hpp"

namespace weft {

/// Errors  Shader, Limit, OutOfMemory, DeviceLost.
Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs);

/// The largest stable step of the scene's solver. Errors as make_solver.
Result<StepLimit> find_step_limit(gpu::Device& device, const scene::Scene& scene, const HostModel& model);

/// The limit of the same scene with another drag. Asks nothing of the GPU.
StepLimit with_drag(const scene::Solver& settings, const StepLimit& limit, double drag);

/// The substeps of a frame that "auto" means: the least multiple of 4 whose step is at most kStepSafety times
/// the largest stable one. Errors  Limit: more than scenes allow.
Result<std::uint32_t> choose_substeps(const scene::Scene& scene, const StepLimit& limit);

/// Where a sheet is crumpled, the springs of a node can come to lie along one line; the sum of |entries| of a
/// row of M^-1 K then bounds the frequency: for a lattice √2 of the flat sheet's, with bend springs up
/// to 1.54. Measured: from a random start of a fifth of a cell without damping, 0.85 ends in an explosion
/// within 2,000 steps, 0.7 does not in 10,000.
inline constexpr double kStepSafety = 0.7;

}  // namespace weft
