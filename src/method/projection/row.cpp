#include "method/projection/row.hpp"

#include <array>

#include "method/projection/sag.hpp"

namespace weft {

Method projection_row(scene::SolverKind kind) {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Membrane, ElementKind::Hinge,
                                        ElementKind::Tet};
  Method row{};
  row.kind = kind;
  row.takes = kTakes;
  row.step_limit = sag_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 4);
  };
  row.cost = nullptr;
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.bounds_nodes = true;
  row.sweeps = true;
  row.sews_fabric = true;
  row.tethers = true;
  row.history = 0;
  return row;
}

}  // namespace weft
