#include "method/mass_spring/plan.hpp"

#include <algorithm>
#include <array>

#include "method/mass_spring/fabric_spectrum.hpp"
#include "method/mass_spring/solid_spectrum.hpp"
#include "method/mass_spring/spectrum.hpp"
#include "model/enclosed.hpp"

namespace weft {

namespace {

NetworkSpectrum elements_of(const Model& model, const Body& body) {
  if (body.solid) return find_solid_spectrum(model, body);
  return body.fabric ? find_fabric_spectrum(model, body) : find_spectrum(stiffest_part(model, body));
}

/// With its gas: no eigenvalue of a sum is above the sum of the largest.
NetworkSpectrum spectrum_of(const Model& model, const Body& body) {
  NetworkSpectrum spectrum = elements_of(model, body);
  spectrum.stiffness += gas_stiffness(model, body);
  return spectrum;
}

NetworkSpectrum spectrum_of(const Model& model, const Body& body, ElementKind kind) {
  if (body.fabric) return find_fabric_spectrum(model, body, kind);
  SpringNetwork network = stiffest_part(model, body);
  ElementTable& left_out = kind == ElementKind::Spring ? network.triples : network.springs;
  left_out = {left_out.kind, {}, {}, {}};
  return find_spectrum(network);
}

double step_of(const NetworkSpectrum& spectrum, double drag) {
  return largest_stable_step(spectrum.stiffness, spectrum.damping + drag);
}

}  // namespace

StepLimit mass_spring_step_limit(const Model& model, double drag) {
  std::vector<NetworkSpectrum> cloths;
  for (const Body& body : model.bodies) cloths.push_back(spectrum_of(model, body));
  return least_step_limit(std::move(cloths), drag);
}

StepCause step_cause(const Model& model, const Body& body, double drag) {
  StepCause cause{step_of(spectrum_of(model, body), drag), {}};
  const auto add = [&](std::optional<ElementKind> kind, double step) {
    if (step > 0) cause.parts.push_back({kind, step});
  };
  std::vector<ElementKind> kinds;
  for (std::size_t k = 0; k < kElementKinds; ++k)
    if (model.count(static_cast<ElementKind>(k), body) > 0) kinds.push_back(static_cast<ElementKind>(k));
  const bool alone = kinds.size() == 1 && !body.gas;  // then it is the cause of all
  for (const ElementKind kind : kinds)
    add(kind, alone ? cause.largest_step : step_of(spectrum_of(model, body, kind), drag));
  if (body.gas) add(std::nullopt, step_of({gas_stiffness(model, body), 0}, drag));
  std::stable_sort(cause.parts.begin(), cause.parts.end(),
                   [](const auto& a, const auto& b) { return a.largest_step < b.largest_step; });
  return cause;
}

Method mass_spring_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple, ElementKind::Membrane,
                                        ElementKind::Hinge, ElementKind::Tet};
  static constexpr MethodCost kCost = {{0.0045, 2.0e-8}, {0.0095, 6.7e-8}, {0.012, 1.0e-6},
                                       {0.14, 1.5e-6},   {0.09, 5.0e-7},   {0.09, 5.0e-7}};
  Method row{};
  row.kind = scene::SolverKind::MassSpring;
  row.takes = kTakes;
  row.step_limit = [](const scene::Scene& scene, const Model& model) {
    return mass_spring_step_limit(model, scene.drag);
  };
  row.with_drag = [](const StepLimit& limit, double drag) { return least_step_limit(limit.cloths, drag); };
  row.auto_substeps = stable_substeps;
  row.cost = &kCost;
  row.memory = [](const scene::Solver& settings) {
    const double springs = settings.forces == scene::Forces::SpringCentric  ? 84
                           : settings.forces == scene::Forces::SpringBlocks ? 67
                                                                            : 0;
    return SolverMemory{springs, 16};
  };
  row.settings_word = [](const scene::Solver& settings) { return scene::name_of(settings.forces); };
  row.search_interval = 4;
  row.holds_obstacles = false;
  row.history = 0;
  return row;
}

}  // namespace weft
