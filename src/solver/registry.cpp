#include "solver/registry.hpp"

#include "model/spectrum.hpp"
#include "solver/mass_spring/solver_mass_spring.hpp"

namespace weft {

Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs) {
  switch (settings.kind) {
    case scene::SolverKind::MassSpring:
      return SolverMassSpring::create(settings, inputs);
  }
  return make_error(ErrorKind::Input, "Solver kind %s is not known.", scene::name_of(settings.kind));
}

StepLimit find_step_limit(const scene::Scene& scene, const HostModel& model) {
  switch (scene.solver.kind) {
    case scene::SolverKind::MassSpring:
      return mass_spring_step_limit(model, scene.drag);
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

}  // namespace weft
