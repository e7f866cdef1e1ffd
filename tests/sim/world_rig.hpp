// Worlds for tests: a scene file or text, its models, a device.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "gpu/gpu_fixture.hpp"
#include "scene/load.hpp"
#include "sim/world.hpp"
#include "source_path.hpp"

namespace weft {

#define REQUIRE_OK(result) REQUIRE_MESSAGE(static_cast<bool>(result), (result).error().message)

inline const std::string kModels = source_path("models");

inline scene::Scene shipped_scene(const std::string& name,
                                  const std::vector<scene::Override>& overrides = {}) {
  auto scene = scene::load_scene(source_path("scenes/" + name + ".json"), overrides);
  REQUIRE_OK(scene);
  return std::move(*scene);
}

inline std::unique_ptr<sim::World> world_from(gpu::Device& device, const scene::Scene& scene,
                                              const Result<Assets>& assets,
                                              const sim::WorldOptions& options = {}) {
  REQUIRE_OK(assets);
  auto world = sim::World::create(device, scene, *assets, options);
  REQUIRE_OK(world);
  return std::move(*world);
}
inline std::unique_ptr<sim::World> world_of(gpu::Device& device, const scene::Scene& scene,
                                            const sim::WorldOptions& options = {}) {
  return world_from(device, scene, load_assets(scene, kModels), options);
}

inline void advance(sim::World& world, std::uint32_t frames) {
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    const auto advanced = world.advance_frame();
    REQUIRE_OK(advanced);
  }
  const auto finished = world.finish();
  REQUIRE_OK(finished);
}

inline std::string hash_of(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  return snapshot->hash();
}

}  // namespace weft
