#pragma once

#include "method/method.hpp"

namespace weft {

/// From so many nodes on "auto" takes multigrid: docs/solvers/multigrid.md has the measurements.
inline constexpr std::size_t kMultigridNodes = 500000;

Method multigrid_method();

}  // namespace weft
