// The methods. A new one: its folder, a row here, and a line in each of the two factories (solvers.cpp, steppers.cpp).
#include <array>

#include "method/fem/plan.hpp"
#include "method/mass_spring/plan.hpp"
#include "method/method.hpp"
#include "method/multigrid/plan.hpp"
#include "method/pbd/plan.hpp"
#include "method/projective_dynamics/plan.hpp"
#include "method/vbd/plan.hpp"
#include "method/xpbd/plan.hpp"

namespace weft {

std::span<const Method> methods() {
  static const std::array rows = {multigrid_method(), mass_spring_method(), xpbd_method(),
                                  pbd_method(),       vbd_method(),         projective_dynamics_method(),
                                  fem_method()};
  return rows;
}

}  // namespace weft
