#include "method/xpbd/plan.hpp"

#include <array>

#include "method/projection/sag.hpp"

namespace weft {

Method xpbd_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Membrane, ElementKind::Hinge};
  Method row{};
  row.kind = scene::SolverKind::Xpbd;
  row.takes = kTakes;
  row.step_limit = sag_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 4);
  };
  row.cost = nullptr;
  row.memory = [](const scene::Solver&) {
    return SolverMemory{96, 72};
  };  // 16 and 12 bytes a spring, six a node
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = false;
  row.sweeps = true;
  row.history = 0;
  return row;
}

}  // namespace weft
