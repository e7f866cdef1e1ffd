#include "method/pbd/plan.hpp"

#include <algorithm>
#include <cmath>

#include "element/membrane/build.hpp"
#include "method/projection/row.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// Equation 3 of docs/solvers/pbd.md: of an element with h² k Σ w |∇C|² = `pull`, by so many sweeps.
double stiffening(double pull, std::uint32_t sweeps) { return std::expm1(sweeps * std::log1p(pull)) / pull; }

/// Of springs, and of warp and weft of triangles, at rest.
StiffeningRange pbd_stiffening(const scene::Solver& settings, const Model& model, const Body& body,
                               double step) {
  StiffeningRange range{HUGE_VAL, 0};
  const auto add = [&](double stiffness, double weight) {
    if (stiffness <= 0 || weight <= 0) return;
    const double times = stiffening(step * step * stiffness * weight, settings.iterations);
    range = {std::min(range.least, times), std::max(range.most, times)};
  };
  for (const Spring& spring : model.springs(body))
    add(spring.stiffness, model.inverse_mass(spring.node_a) + model.inverse_mass(spring.node_b));
  if (!body.fabric) return range;
  const Stiffness stiffness = membrane_law(*body.fabric).stiffness;
  const ElementTable& membranes = model.elements(ElementKind::Membrane, body);
  for (std::size_t t = 0; t < membranes.size(); ++t) {
    const membrane::Rest rest = membrane::rest_of(membranes, t);
    double warp = 0, weft = 0;  // Σ w |∇ε|² at rest
    for (std::size_t i = 0; i < 3; ++i) {
      const double w = model.inverse_mass(membranes.nodes_of(t)[i]);
      warp += w * rest.slope[i].warp * rest.slope[i].warp;
      weft += w * rest.slope[i].weft * rest.slope[i].weft;
    }
    add(rest.area * stiffness.warp, warp);
    add(rest.area * stiffness.weft, weft);
  }
  return range;
}

}  // namespace

Method pbd_method() {
  Method row = projection_row(scene::SolverKind::Pbd);
  row.memory = [](const scene::Solver&) { return SolverMemory{72, 72}; };  // 12 bytes a spring, six a node
  row.stiffening = pbd_stiffening;
  row.blow_part = 0.025;
  return row;
}

}  // namespace weft
