#pragma once

#include <string>

#include "model/host_model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// From so many nodes on "auto" is multigrid: docs/solvers/multigrid.md has the measurements.
inline constexpr std::size_t kMultigridNodes = 100000;

/// Which solver a scene gets, and why if the scene leaves that open.
struct SolverChoice {
  scene::SolverKind kind = scene::SolverKind::MassSpring;  // never Auto
  std::string reason;                                      // empty: the scene names it
};

SolverChoice choose_solver(const scene::Scene& scene, const HostModel& model);

}  // namespace weft
