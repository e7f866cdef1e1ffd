#pragma once

#include <cstdint>

#include "base/result.hpp"
#include "model/assets.hpp"

namespace weft::cli {

/// Bytes that this program may still use without others being swapped out, as Linux estimates it, and within
/// its own limit.
/// Errors  Failure: this system does not say.
Result<std::uint64_t> available_memory();

/// Whether the host has memory for a world of this scene; where it does not say how much it has, it has
/// enough. Errors  Limit.
Result<void> check_host_memory(const scene::Scene& scene, const Assets& assets);

}  // namespace weft::cli
