#include "method/multigrid/plan.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

StepLimit step_limit(const scene::Scene& scene, const Model& model) {
  StepLimit limit;  // implicit steps are stable at any length
  limit.contact_step = contact_step(scene, model);
  return limit;
}

Result<std::uint32_t> auto_substeps(const scene::Scene& scene, const StepLimit& limit) {
  double step = kImplicitStep;
  if (limit.contact_step > 0) step = std::min(step, limit.contact_step);
  const double steps = scene.time.frame / step * (1 - 1e-12);  // an even number is not rounded up
  return static_cast<std::uint32_t>(4 * std::ceil(steps / 4));
}

AutoVerdict auto_verdict(const Model& model) {
  const auto is_mesh = [](const Body& body) { return !body.grid; };
  if (std::any_of(model.bodies.begin(), model.bodies.end(), is_mesh))
    return {false, "a cloth is a mesh, and multigrid is taken for grids only"};
  const std::string nodes = std::to_string(model.vertex_count()) + " nodes are ";
  const std::string bound = std::to_string(kMultigridNodes) + ", from which on multigrid is cheaper";
  if (model.vertex_count() < kMultigridNodes) return {false, nodes + "fewer than the " + bound};
  return {true, nodes + "not fewer than the " + bound};
}

}  // namespace

Method multigrid_method() {
  Method row{};
  row.kind = scene::SolverKind::Multigrid;
  row.step_limit = step_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = auto_substeps;
  row.auto_verdict = auto_verdict;
  row.memory = [](const scene::Solver&) { return SolverMemory{222, 128}; };
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.history = 1;  // BDF2
  return row;
}

}  // namespace weft
