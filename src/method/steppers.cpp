// A line a method.
#include "method/mass_spring/reference/mass_spring_stepper.hpp"
#include "method/multigrid/reference/implicit_step.hpp"
#include "method/stepper.hpp"

namespace weft::reference {

std::unique_ptr<Stepper> make_stepper(scene::SolverKind kind, const Model& model) {
  switch (kind) {
    case scene::SolverKind::Multigrid:
      return std::make_unique<ImplicitStepper>(model);
    case scene::SolverKind::MassSpring:
    case scene::SolverKind::Auto:
      break;
  }
  return std::make_unique<MassSpringStepper>(model);
}

}  // namespace weft::reference
