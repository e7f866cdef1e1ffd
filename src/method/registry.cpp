#include "method/registry.hpp"

#include "method/mass_spring/spectrum.hpp"
#include "method/mass_spring/solver_mass_spring.hpp"
#include "method/multigrid/solver_multigrid.hpp"

namespace weft {

Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs) {
  switch (settings.kind) {
    case scene::SolverKind::MassSpring:
      return SolverMassSpring::create(settings, inputs);
    case scene::SolverKind::Multigrid:
      return SolverMultigrid::create(inputs);
    case scene::SolverKind::Auto:
      break;
  }
  return make_error(ErrorKind::Input, "Solver kind %s cannot be made.", scene::name_of(settings.kind));
}

StepLimit find_step_limit(scene::SolverKind kind, const scene::Scene& scene, const HostModel& model) {
  if (kind == scene::SolverKind::MassSpring) return mass_spring_step_limit(model, scene.drag);
  StepLimit limit;  // implicit steps are stable at any length
  limit.contact_step = contact_step(scene, model);
  return limit;
}

StepLimit with_drag(scene::SolverKind kind, const StepLimit& limit, double drag) {
  if (kind == scene::SolverKind::MassSpring) return least_step_limit(limit.cloths, drag);
  return limit;
}

}  // namespace weft
