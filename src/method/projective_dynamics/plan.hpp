#pragma once

#include "method/method.hpp"

namespace weft {

Method projective_dynamics_method();

}  // namespace weft
