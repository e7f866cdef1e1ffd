// Simulations for tests: a scene file or text, and its models.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "model/assets.hpp"
#include "reference/simulation.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"

namespace weft {

#define REQUIRE_OK(result) REQUIRE_MESSAGE(static_cast<bool>(result), (result).error().message)

inline reference::Simulation simulation_of(const scene::Scene& scene) {
  const auto assets = load_assets(scene, source_path("models"));
  REQUIRE_OK(assets);
  auto simulation = reference::Simulation::create(scene, *assets);
  REQUIRE_OK(simulation);
  return std::move(*simulation);
}

inline reference::Simulation simulation_of_file(const std::string& name,
                                                const std::vector<scene::Override>& overrides) {
  const auto scene = scene::load_scene(source_path("scenes/" + name + ".json"), overrides);
  REQUIRE_OK(scene);
  return simulation_of(*scene);
}

/// Of mass_spring where the members name no solver.
inline reference::Simulation simulation_of_text(const std::string& members) {
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", )" + members + "}", "test.json");
  REQUIRE_OK(scene);
  if (scene->solver.kind == scene::SolverKind::Auto) scene->solver.kind = scene::SolverKind::MassSpring;
  return simulation_of(*scene);
}

inline void advance(reference::Simulation& simulation, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    const auto advanced = simulation.advance_frame();
    REQUIRE_OK(advanced);
  }
}

}  // namespace weft
