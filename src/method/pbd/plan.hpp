#pragma once

#include "method/method.hpp"

namespace weft {

Method pbd_method();

}  // namespace weft
