#include "method/implicit_row.hpp"

#include <array>

namespace weft {
namespace {

/// Contact gives a substep a second system.
StepLimit step_limit(const scene::Scene& scene, const Model& model) {
  const Method row = implicit_row(scene.solver.kind);
  StepLimit limit;
  limit.longest_auto_step = solved_contact(scene, row).obstacles ? kImplicitContactStep
                            : leaves_obstacles(scene, row)       ? kBlowStep
                                                                 : kImplicitStep;
  return with_gas(limit, model, kMostOfGasAhead);
}

}  // namespace

Method implicit_row(scene::SolverKind kind) {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple, ElementKind::Membrane,
                                        ElementKind::Hinge, ElementKind::Tet};
  Method row{};
  row.kind = kind;
  row.takes = kTakes;
  row.step_limit = step_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 2);
  };
  row.cost = nullptr;
  row.memory = [](const scene::Solver&) { return SolverMemory{347, 193}; };
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.holds_pairs = true;
  row.limits_strain = true;
  row.sews_fabric = true;
  row.blow_part = 0.025;
  row.history = 1;  // BDF2
  row.order = 2;
  return row;
}

}  // namespace weft
