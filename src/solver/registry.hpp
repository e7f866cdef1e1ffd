// Which solver a scene's "solver" object means. A new solver is one line in each function of registry.cpp.
#pragma once

#include "solver/solver.hpp"

namespace weft {

/// Errors  Shader, Limit, OutOfMemory, DeviceLost.
Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs);

/// The largest stable step of the scene's solver.
StepLimit find_step_limit(const scene::Scene& scene, const HostModel& model);

/// The limit of the same scene with another drag, without finding the spectrum again.
StepLimit with_drag(const scene::Solver& settings, const StepLimit& limit, double drag);

}  // namespace weft
