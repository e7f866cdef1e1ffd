#pragma once

#include <optional>
#include <string>

#include "sim/world.hpp"

namespace weft::sim {

/// The whole state of a world whose cloth tears now, as of the world that is torn so: made with the tears of it
/// (WorldOptions), that world opens it. None: nothing tears. Positions, velocities and creases stay as they are, each
/// part of a node has its place and velocity, and so mass, momentum and angular momentum are kept. Forces of pairs are
/// forgotten, as are those that obstacles hold the parted nodes with.
/// Errors  as World::save.
Result<std::optional<SavedState>> torn_state(World& world, const std::string& build);

}  // namespace weft::sim
