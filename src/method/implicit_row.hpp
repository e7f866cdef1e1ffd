#pragma once

#include "method/method.hpp"

namespace weft {

/// The row of a method whose systems are those of implicit steps of second order, with obstacles in them. "auto" does
/// not take it.
Method implicit_row(scene::SolverKind kind);

}  // namespace weft
