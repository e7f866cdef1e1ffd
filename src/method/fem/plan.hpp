#pragma once

#include "method/method.hpp"

namespace weft {

Method fem_method();

}  // namespace weft
