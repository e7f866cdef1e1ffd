// Where a scene's own grabs pull, and how many hold at once.
#pragma once

#include <span>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

inline constexpr std::size_t kMaxGrabs = 4;  // grabbed at once; the same in src/state/step.wgsl

/// Whether the grab is active in the substep that ends at `time` [s].
bool active_at(const Grab& grab, double time);
/// Whether there is a time in both grabs.
bool overlap(const Grab& a, const Grab& b);
/// Where the node is pulled at `time` [s]: straight between the path's points, still before and after them.
Vec3d target_at(const Grab& grab, double time);

}  // namespace weft::scene
