#include "method/solver_choice.hpp"

#include <algorithm>

namespace weft {

SolverChoice choose_solver(const scene::Scene& scene, const HostModel& model) {
  using Kind = scene::SolverKind;
  if (scene.solver.kind != Kind::Auto) return {scene.solver.kind, ""};
  const auto is_mesh = [](const ClothModel& cloth) { return !cloth.grid; };
  if (std::any_of(model.cloths.begin(), model.cloths.end(), is_mesh))
    return {Kind::MassSpring, "a cloth is a mesh, and multigrid is taken for grids only"};
  const std::string nodes = std::to_string(model.vertex_count()) + " nodes are ";
  const std::string bound = std::to_string(kMultigridNodes) + ", from which on multigrid is cheaper";
  if (model.vertex_count() < kMultigridNodes) return {Kind::MassSpring, nodes + "fewer than the " + bound};
  return {Kind::Multigrid, nodes + "not fewer than the " + bound};
}

}  // namespace weft
