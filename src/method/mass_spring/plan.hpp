#pragma once

#include <optional>

#include "method/method.hpp"

namespace weft {

Method mass_spring_method();

/// The largest stable step of the springs of all cloths.
StepLimit mass_spring_step_limit(const Model& model, double drag);

/// The largest stable step of one cloth, and of each kind of its elements and its gas by itself [s]; 0: any step is.
struct StepCause {
  struct Part {
    std::optional<ElementKind> kind;  // none: of the gas that it encloses
    double largest_step;
  };
  double largest_step = 0;
  std::vector<Part>
      parts;  // the one that allows the least first; kinds that the cloth does not have are left out
};
StepCause step_cause(const Model& model, const Body& body, double drag);

}  // namespace weft
