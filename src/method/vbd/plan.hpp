#pragma once

#include "method/method.hpp"

namespace weft {

Method vbd_method();

}  // namespace weft
