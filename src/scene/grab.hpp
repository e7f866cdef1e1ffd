// Where a scene's own grabs pull, and how many hold at once.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

inline constexpr std::size_t kMaxGrabs = 1024;  // grabbed at once

/// Whether the grab is active in the substep that ends at `time` [s].
bool active_at(const Grab& grab, double time);
/// Whether there is a time in both grabs.
bool overlap(const Grab& a, const Grab& b);
/// When something holds [s].
struct Hold {
  double start = 0, end = 0;
};
Hold hold_of(const Grab& grab);
/// How many of these hold when most do, and from when on [s]. One that ends as another starts does not count with it.
struct MostAtOnce {
  std::size_t count = 0;
  double time = 0;
};
MostAtOnce most_at_once(std::vector<Hold> holds);
/// Where the node is pulled at `time` [s]: straight between the path's points, still before and after them.
Vec3d target_at(const Grab& grab, double time);

}  // namespace weft::scene
