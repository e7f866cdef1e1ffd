#include "solver/registry.hpp"

#include <cmath>

#include "solver/mass_spring/solver_mass_spring.hpp"
#include "solver/mass_spring/stability.hpp"

namespace weft {

Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs) {
  switch (settings.kind) {
    case scene::SolverKind::MassSpring:
      return SolverMassSpring::create(settings, inputs);
  }
  return make_error(ErrorKind::Input, "Solver kind %s is not known.", scene::name_of(settings.kind));
}

Result<StepLimit> find_step_limit(gpu::Device& device, const scene::Scene& scene, const HostModel& model) {
  switch (scene.solver.kind) {
    case scene::SolverKind::MassSpring:
      return mass_spring_step_limit(device, model, scene.drag);
  }
  return StepLimit{};
}

StepLimit with_drag(const scene::Solver& settings, const StepLimit& limit, double drag) {
  switch (settings.kind) {
    case scene::SolverKind::MassSpring:
      return least_step_limit(limit.cloths, drag);
  }
  return limit;
}

Result<std::uint32_t> choose_substeps(const scene::Scene& scene, const StepLimit& limit) {
  constexpr double kMostSubsteps = 65536;  // docs/scene.md, time.substeps
  if (limit.largest_step <= 0) return 1U;
  const double substeps = 4 * std::ceil(scene.time.frame / (kStepSafety * limit.largest_step) / 4);
  if (!(substeps <= kMostSubsteps))
    return make_error(
        ErrorKind::Limit,
        "The cloth's springs need %.0f substeps a frame (largest stable step %.3g s), more than the limit "
        "of %.0f: lower the stiffness or the resolution, or raise the density.",
        substeps, limit.largest_step, kMostSubsteps);
  return static_cast<std::uint32_t>(substeps);
}

}  // namespace weft
