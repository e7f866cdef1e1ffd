#include "method/mass_spring/plan.hpp"

#include <array>

#include "method/mass_spring/fabric_spectrum.hpp"
#include "method/mass_spring/spectrum.hpp"

namespace weft {

StepLimit mass_spring_step_limit(const Model& model, double drag) {
  std::vector<NetworkSpectrum> cloths;
  for (const Body& body : model.bodies)
    cloths.push_back(body.fabric ? find_fabric_spectrum(model, body)
                                 : find_spectrum(stiffest_part(model, body)));
  return least_step_limit(std::move(cloths), drag);
}

Method mass_spring_method() {
  static constexpr std::array kTakes = {ElementKind::Spring, ElementKind::Triple, ElementKind::Membrane,
                                        ElementKind::Hinge};
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
