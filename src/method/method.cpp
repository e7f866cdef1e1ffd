#include "method/method.hpp"

#include <algorithm>
#include <cassert>

namespace weft {

const Method& method_of(scene::SolverKind kind) {
  const auto rows = methods();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const Method& method) { return method.kind == kind; });
  assert(row != rows.end());  // every kind of scenes but Auto has a row: tests/method/test_methods.cpp
  return *row;
}

MethodChoice choose_method(const scene::Scene& scene, const Model& model) {
  if (scene.solver.kind != scene::SolverKind::Auto) return {&method_of(scene.solver.kind), ""};
  MethodChoice choice;
  for (const Method& method : methods()) {
    if (method.auto_verdict == nullptr) continue;
    AutoVerdict verdict = method.auto_verdict(model);
    if (!verdict.reason.empty()) choice.reason = std::move(verdict.reason);
    if (!verdict.takes) continue;
    choice.method = &method;
    break;
  }
  return choice;
}

Result<std::uint32_t> choose_substeps(const scene::Scene& scene, const Method& method,
                                      const StepLimit& limit) {
  if (scene.time.substeps) return *scene.time.substeps;
  return method.auto_substeps(scene, limit);
}

bool solves_with_obstacles(const scene::Scene& scene, const Method& method) {
  return method.holds_obstacles && scene.contact.method == scene::ContactMethod::Proximity &&
         !scene.colliders.empty() && scene.contact.restitution == 0;
}

}  // namespace weft
