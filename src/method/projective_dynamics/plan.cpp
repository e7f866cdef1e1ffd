#include "method/projective_dynamics/plan.hpp"

#include <algorithm>
#include <array>

#include "method/projective_dynamics/relaxation.hpp"

namespace weft {
namespace {

/// Equation 9 of docs/solvers/projective_dynamics.md for the cloth that needs the shortest.
StepLimit projective_dynamics_step_limit(const scene::Scene& scene, const Model& model) {
  const double rate = reached_rate(scene.solver.iterations);
  StepLimit limit;
  limit.longest_auto_step = kImplicitStep;
  for (const Body& cloth : model.bodies)
    limit.longest_auto_step = std::min(limit.longest_auto_step, cloth_rates(model, cloth).step_of(rate));
  return with_gas(limit, model, kMostOfGas);
}

}  // namespace

Method projective_dynamics_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Membrane, ElementKind::Hinge,
                                        ElementKind::Tet};
  static constexpr std::array kEnergies = {scene::FabricEnergy::Yarn};
  Method row{};
  row.kind = scene::SolverKind::ProjectiveDynamics;
  row.takes = kTakes;
  // Its matrix never changes: it holds the energy of yarns, and that of bending out of a plane.
  row.energies = kEnergies;
  static constexpr std::array kSolids = {scene::SolidEnergy::Corotated};
  row.solid_energies = kSolids;  // each is near a rotation
  row.flat_fabric = true;
  row.step_limit = projective_dynamics_step_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 4);
  };
  row.cost = nullptr;
  row.memory = [](const scene::Solver&) {
    return SolverMemory{228, 96};
  };  // 8 bytes for each end of a spring; of the rest 48 with obstacles alone
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.bounds_nodes = true;
  row.sweeps = true;
  row.blow_part = 0.0002;
  row.history = 1;  // the velocity before, for the guess of a substep
  return row;
}

}  // namespace weft
