// A line a method.
#include "method/mass_spring/reference/mass_spring_stepper.hpp"
#include "method/multigrid/reference/implicit_step.hpp"
#include "method/projection/reference/projection_stepper.hpp"
#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"
#include "method/stepper.hpp"
#include "method/vbd/reference/vbd_stepper.hpp"

namespace weft::reference {

std::unique_ptr<Stepper> make_stepper(const scene::Solver& settings, const Model& model, double step) {
  switch (settings.kind) {
    case scene::SolverKind::Multigrid:
      return std::make_unique<ImplicitStepper>(model, step, settings.residual);
    case scene::SolverKind::Fem:
      return std::make_unique<ImplicitStepper>(model, step, settings.residual, settings.iterations);
    case scene::SolverKind::Xpbd:
      return std::make_unique<ProjectionStepper>(model, settings.iterations, Multipliers::Kept);
    case scene::SolverKind::Pbd:
      return std::make_unique<ProjectionStepper>(model, settings.iterations, Multipliers::Forgotten);
    case scene::SolverKind::Vbd:
      return std::make_unique<VbdStepper>(model, settings.iterations);
    case scene::SolverKind::ProjectiveDynamics:
      return std::make_unique<ProjectiveDynamicsStepper>(model, step, settings.iterations);
    case scene::SolverKind::MassSpring:
    case scene::SolverKind::Auto:
      break;
  }
  return std::make_unique<MassSpringStepper>(model);
}

}  // namespace weft::reference
