#include "method/multigrid/plan.hpp"

#include <array>

namespace weft {

Method multigrid_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple, ElementKind::Membrane,
                                        ElementKind::Hinge};
  static constexpr MethodCost kCost = {{0.45, 1.95e-6}, {0.29, 1.6e-5}, {0.6, 1.2e-5},
                                       {0.9, 2.8e-5},   {0.9, 9.3e-5},  {1.0, 2.0e-5}};
  Method row{};
  row.kind = scene::SolverKind::Multigrid;
  row.takes = kTakes;
  row.step_limit = [](const scene::Scene& scene, const Model&) {
    return implicit_limit(solves_with_contact(scene, multigrid_method()));
  };
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 2);
  };
  row.cost = &kCost;
  row.memory = [](const scene::Solver&) { return SolverMemory{347, 193}; };
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.limits_strain = true;
  row.history = 1;  // BDF2
  row.order = 2;
  return row;
}

}  // namespace weft
