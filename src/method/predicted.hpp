#pragma once

#include <array>

#include "gpu/buffer.hpp"

namespace weft {

/// Where the predicted velocity of a substep goes, by its parity: to the state, or, where contact asks for
/// the velocities of other vertices while it writes its own, aside.
using Predicted = std::array<const gpu::RawBuffer*, 2>;

}  // namespace weft
