#include "method/multigrid/plan.hpp"

#include <algorithm>
#include <array>

namespace weft {
namespace {

StepLimit step_limit(const scene::Scene&, const Model&) {
  StepLimit limit;  // implicit steps are stable at any length
  limit.longest_auto_step = kImplicitStep;
  return limit;
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
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple};
  Method row{};
  row.kind = scene::SolverKind::Multigrid;
  row.takes = kTakes;
  row.step_limit = step_limit;
  row.with_drag = [](const StepLimit& limit, double) { return limit; };
  row.auto_substeps = long_substeps;
  row.auto_verdict = auto_verdict;
  row.memory = [](const scene::Solver&) { return SolverMemory{299, 193}; };
  row.settings_word = [](const scene::Solver&) { return ""; };
  row.search_interval = 1;
  row.holds_obstacles = true;
  row.history = 1;  // BDF2
  return row;
}

}  // namespace weft
