#include "method/method.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

namespace weft {
namespace {

bool takes(const Method& method, ElementKind kind) {
  return std::find(method.takes.begin(), method.takes.end(), kind) != method.takes.end();
}

/// "a", "a" or "b", "a", "b" or "c".
std::string words_of_methods_for(ElementKind kind) {
  std::vector<std::string> words;
  for (const Method& method : methods())
    if (takes(method, kind)) words.push_back('"' + std::string(scene::name_of(method.kind)) + '"');
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace

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

Result<void> check_elements(const scene::Scene& scene, const Model& model, const Method& method) {
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    for (std::size_t k = 0; k < kElementKinds; ++k) {
      const auto kind = static_cast<ElementKind>(k);
      if (takes(method, kind) || model.count(kind, model.bodies[c]) == 0) continue;
      return input_error("%s has %s, which solver.kind \"%s\" does not take; %s does.",
                         scene.cloths[c].where.c_str(), kElementNames[k], scene::name_of(method.kind),
                         words_of_methods_for(kind).c_str());
    }
  }
  return {};
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
