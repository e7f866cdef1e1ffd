#include "method/pbd/plan.hpp"

#include <algorithm>
#include <cmath>

#include "element/membrane/build.hpp"
#include "method/projection/row.hpp"
#include "model/fabric.hpp"
#include "model/solid.hpp"

namespace weft {
namespace {

/// Equation 3 of docs/solvers/pbd.md: of an element with h² k Σ w |∇C|² = `pull`, projected so often.
double stiffening(double pull, std::uint32_t times) { return std::expm1(times * std::log1p(pull)) / pull; }

/// Of springs, of warp and weft of triangles, and of shear and volume of tetrahedra, at rest.
StiffeningRange pbd_stiffening(const scene::Solver& settings, const Model& model, const Body& body,
                               double step) {
  StiffeningRange range{HUGE_VAL, 0};
  const auto add = [&](double stiffness, double weight, std::uint32_t projections) {
    if (stiffness <= 0 || weight <= 0) return;
    const double times = stiffening(step * step * stiffness * weight, projections);
    range = {std::min(range.least, times), std::max(range.most, times)};
  };
  for (const Spring& spring : model.springs(body))
    add(spring.stiffness, model.inverse_mass(spring.node_a) + model.inverse_mass(spring.node_b),
        settings.iterations);
  if (body.solid) {
    const tet::Tets tets = body_tets(model, body);
    for (std::size_t t = 0; t < tets.tets.size(); ++t) {
      const tet::Rest& rest = tets.rests[t];
      double weight = 0;  // Σ w |n|² / 3, of each direction
      for (std::size_t i = 0; i < 4; ++i)
        weight +=
            model.inverse_mass(body.first_vertex + tets.tets[t][i]) * dot(rest.slope[i], rest.slope[i]) / 3;
      for (const double modulus : {2 * tets.law.mu, 2 * tets.law.mu + 3 * tets.law.lambda})
        add(rest.volume * modulus, weight, 2 * settings.iterations);  // there and back
    }
  }
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
    add(rest.area * stiffness.warp, warp, settings.iterations);
    add(rest.area * stiffness.weft, weft, settings.iterations);
  }
  return range;
}

}  // namespace

Method pbd_method() {
  Method row = projection_row(scene::SolverKind::Pbd);
  row.memory = [](const scene::Solver&) {
    return SolverMemory{136, 72};
  };  // 12 bytes a spring; of the rest 64 with obstacles alone
  row.stiffening = pbd_stiffening;
  row.blow_part = 0.025;
  return row;
}

}  // namespace weft
