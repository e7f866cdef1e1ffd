// A run's state in a file, to go on from.
#pragma once

#include <string>

#include "sim/world.hpp"

namespace weft::cli {

/// This program, as saved states name what they come from.
std::string build_name();

/// What a file has, for a world of its scene, which is whole.
/// Errors  Input: no such file, no saved state, larger than this scene's can be.
Result<sim::SavedState> read_checkpoint(const std::string& path, const sim::World& world);

/// Says whether the bits may differ from those of a run that never stopped; "" where they are the same.
std::string other_origin(const sim::SavedState& state, const sim::World& world);

/// "checkpoint_00012.weft", after so many frames.
std::string checkpoint_name(std::uint32_t frames);

}  // namespace weft::cli
