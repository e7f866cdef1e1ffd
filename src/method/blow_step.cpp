#include "method/blow_step.hpp"

#include <algorithm>
#include <cmath>

#include "method/mass_spring/plan.hpp"
#include "method/step_limit.hpp"
#include "model/cloth_size.hpp"

namespace weft {
namespace {

/// Force per width and stretch of the stiffest cloth, along its yarns [N/m].
double stiffest_modulus(const Model& model) {
  double stiffest = 0;
  for (const Body& body : model.bodies) {
    if (body.solid) continue;
    stiffest = std::max(stiffest, body.fabric ? std::max(body.fabric->warp, body.fabric->weft)
                                              : std::max(body.stiffness.structural, body.stiffness.shear));
  }
  return stiffest;
}

}  // namespace

double blow_step(const scene::Scene& scene, const Model& model, double lightest, double part) {
  const double modulus = stiffest_modulus(model);
  if (modulus == 0) return HUGE_VAL;
  for (const Body& body : model.bodies)
    if (!body.solid) lightest = std::min(lightest, mass_of(model, body));
  const double feels = kStepSafety * mass_spring_step_limit(model, scene.drag).largest_step;
  return std::max(feels, std::sqrt(part * lightest / modulus));
}

}  // namespace weft
