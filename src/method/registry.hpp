// Which solver a scene's "solver" object means. A new solver is one line in each function of registry.cpp.
#pragma once

#include "method/solver.hpp"

namespace weft {

/// What a scene's "auto" has become must be said (model/solver_choice.hpp).
/// Errors  Shader, Limit, OutOfMemory, DeviceLost. Input: the kind is Auto.
Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs);

/// The largest stable step of a solver in a scene.
StepLimit find_step_limit(scene::SolverKind kind, const scene::Scene& scene, const HostModel& model);

/// The limit of the same scene with another drag, without finding the spectrum again.
StepLimit with_drag(scene::SolverKind kind, const StepLimit& limit, double drag);

}  // namespace weft
