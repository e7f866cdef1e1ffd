#pragma once

#include "method/method.hpp"

namespace weft {

Method mass_spring_method();

/// The largest stable step of the springs of all cloths.
StepLimit mass_spring_step_limit(const Model& model, double drag);

}  // namespace weft
