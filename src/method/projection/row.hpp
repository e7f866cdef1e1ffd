#pragma once

#include "method/method.hpp"

namespace weft {

/// The row of a method whose sweeps project elements, but for what its multipliers make of it: its memory.
Method projection_row(scene::SolverKind kind);

}  // namespace weft
