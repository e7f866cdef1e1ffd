#pragma once

#include "method/method.hpp"

namespace weft {

Method xpbd_method();

}  // namespace weft
