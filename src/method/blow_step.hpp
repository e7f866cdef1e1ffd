// How long "auto" lets a step be where impulses answer rigid bodies after the solve.
#pragma once

#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// The longest step in which a rigid body's blow gives cloth no more energy than the body has [s]; infinite without
/// cloth. `part` is the method's (Method::blow_part), `lightest` the least mass of a rigid body [kg]. Not below what
/// "auto" gives explicit steps, which feel a blow in the substep in which it comes.
/// Source: docs/rigid.md, equation 6.
double blow_step(const scene::Scene& scene, const Model& model, double lightest, double part);

}  // namespace weft
