#pragma once

#include <array>

#include "gpu/buffer.hpp"

namespace weft {

/// The destination of a substep's predicted velocity, by its parity: the state, or, where contact needs
/// the velocities of other vertices while it writes its own, aside.
using Predicted = std::array<const gpu::RawBuffer*, 2>;

}  // namespace weft
