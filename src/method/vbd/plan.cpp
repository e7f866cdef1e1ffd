#include "method/vbd/plan.hpp"

#include <array>

#include "method/step_limit.hpp"

namespace weft {
namespace {

StepLimit vbd_step_limit(const scene::Scene& scene, const Model& model) {
  StepLimit limit;
  limit.longest_auto_step = leaves_obstacles(scene, vbd_method()) ? kBlowStep : kImplicitStep;
  return with_gas(limit, model, kMostOfGas);
}

}  // namespace

Method vbd_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Membrane, ElementKind::Hinge,
                                        ElementKind::Tet};
  Method row{};
  row.kind = scene::SolverKind::Vbd;
  row.takes = kTakes;
  row.step_limit = vbd_step_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = [](const scene::Scene& scene, const StepLimit& limit) {
    return long_substeps(scene, limit, 4);
  };
  row.cost = nullptr;
  row.memory = [](const scene::Solver&) {
    return SolverMemory{164, 96};
  };  // 8 bytes for each end of a spring; of the rest 48 with obstacles alone
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.bounds_nodes = true;
  row.sweeps = true;
  row.blow_part = 0.025;
  row.even_poisson = 0.49;
  row.history = 1;  // the velocity before, for the guess of a substep
  return row;
}

}  // namespace weft
