#include "method/fem/plan.hpp"

#include <array>

namespace weft {

Method fem_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple, ElementKind::Membrane,
                                        ElementKind::Hinge};
  Method row{};
  row.kind = scene::SolverKind::Fem;
  row.takes = kTakes;
  row.step_limit = [](const scene::Scene& scene, const Model&) {
    return implicit_limit(solves_with_contact(scene, fem_method()));
  };
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 2);
  };
  row.cost = nullptr;
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
