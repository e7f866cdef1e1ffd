// A line a method.
#include "method/mass_spring/solver_mass_spring.hpp"
#include "method/multigrid/solver_multigrid.hpp"
#include "method/projection/solver_projection.hpp"
#include "method/projective_dynamics/solver_projective_dynamics.hpp"
#include "method/vbd/solver_vbd.hpp"

namespace weft {

Result<std::unique_ptr<Solver>> make_solver(const scene::Solver& settings, const SolverInputs& inputs) {
  switch (settings.kind) {
    case scene::SolverKind::MassSpring:
      return SolverMassSpring::create(settings, inputs);
    case scene::SolverKind::Multigrid:
      return SolverMultigrid::create(inputs, settings.residual);
    case scene::SolverKind::Fem:
      return SolverMultigrid::create(inputs, settings.residual, settings.iterations);
    case scene::SolverKind::Xpbd:
      return SolverProjection::create(inputs, settings.iterations, Multipliers::Kept);
    case scene::SolverKind::Pbd:
      return SolverProjection::create(inputs, settings.iterations, Multipliers::Forgotten);
    case scene::SolverKind::Vbd:
      return SolverVbd::create(settings, inputs);
    case scene::SolverKind::ProjectiveDynamics:
      return SolverProjectiveDynamics::create(settings, inputs);
    case scene::SolverKind::Auto:
      break;
  }
  return make_error(ErrorKind::Failure, "Solver kind %s cannot be made.", scene::name_of(settings.kind));
}

}  // namespace weft
