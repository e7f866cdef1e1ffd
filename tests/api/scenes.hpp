#pragma once

#include <doctest/doctest.h>

#include "weft/weft.hpp"

#define REQUIRE_OK(expression)                                    \
  do {                                                            \
    const auto& ok_ = (expression);                               \
    REQUIRE_MESSAGE(static_cast<bool>(ok_), ok_.error().message); \
  } while (false)

namespace weft {

/// A sheet of 20 x 20 nodes by two corners, which swings down.
inline constexpr const char* kSheet = R"({ "format": "weft-scene/1", "solver": {"kind": "mass_spring"},
    "contact": { "method": "none" },
  "cloths": [{ "grid": [20, 20], "size": [1, 1], "plane": "xz", "density": 0.2,
                "pins": ["top_left", "top_right"] }] })";

inline Scene scene_of(const char* text) {
  auto scene = Scene::from_text(text);
  REQUIRE_OK(scene);
  return std::move(*scene);
}

inline World world_of(const Scene& scene) {
  auto world = World::create(scene);
  REQUIRE_OK(world);
  return std::move(*world);
}

inline std::string hash_after(World& world, std::uint32_t frames) {
  const auto done = world.advance(frames);
  REQUIRE_OK(done);
  auto hash = world.state_hash();
  REQUIRE_OK(hash);
  return *hash;
}

}  // namespace weft
