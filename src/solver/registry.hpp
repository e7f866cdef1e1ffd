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

}  // namespace weft
