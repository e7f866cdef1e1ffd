#pragma once

#include <memory>

#include "sim/world.hpp"

namespace weft::bench {

/// Counts the edges that pass through a scene's objects or its cloth, by the search of proximity contact with
/// self-contact: the same count for the states of all methods.
class CrossingCount {
 public:
  /// Errors  as sim::World::create.
  static Result<CrossingCount> create(gpu::Device& device, scene::Scene scene, const Assets& assets);
  /// Errors  DeviceLost, OutOfMemory.
  Result<std::uint32_t> of(const sim::Snapshot& state);

 private:
  std::unique_ptr<sim::World> world_;
};

}  // namespace weft::bench
