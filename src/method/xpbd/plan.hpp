#pragma once

#include "method/method.hpp"

namespace weft {

/// By what part of itself "auto" lets a sheet that hangs by an edge be longer than its springs say.
inline constexpr double kSag = 0.005;

Method xpbd_method();

}  // namespace weft
