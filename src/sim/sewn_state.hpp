#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/sewing.hpp"
#include "sim/world.hpp"

namespace weft::sim {

/// The whole state of a world that is sewn on now, as of the world that is sewn so: made with its sewing
/// (WorldOptions), that world opens it.
struct SewnState {
  std::optional<SavedState> state;  // none: threads go on as they are
  std::vector<SeamNews> news;
};

/// Nodes that become one are at their centre of mass, with its velocity: mass, momentum and centre of mass are kept.
/// Where any do, forces of pairs are forgotten, and nothing has a step before. Else the state is as it was.
/// Errors  as World::save.
Result<SewnState> sewn_state(World& world, const std::string& build);

}  // namespace weft::sim
