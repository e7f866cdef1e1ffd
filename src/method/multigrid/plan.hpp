#pragma once

#include "method/method.hpp"

namespace weft {

Method multigrid_method();

}  // namespace weft
