#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/saved_state.hpp"
#include "sim/world.hpp"

namespace weft::sim {

/// Whether a scene's mesh may change while it runs, so that change_mesh is due before each frame.
bool may_change_mesh(const scene::Scene& scene);

/// What came of it.
struct MeshChange {
  bool changed = false;           // the world was made anew
  std::vector<std::string> news;  // sentences: a cloth has begun to tear, a seam is closed or does not close
};
/// Sews on what is to be sewn and tears what bears too much before the next frame. Where any does, the world is made
/// anew: with other nodes and triangles, at the same frame. `let_go` is called before the old one goes.
/// Errors  as World::save, World::create and `let_go`; there may be no world afterwards.
Result<MeshChange> change_mesh(std::unique_ptr<World>& world, const std::string& build,
                               const std::function<Result<void>()>& let_go = {});

/// Goes on from a state; where its cloth is torn or sewn otherwise, in a world made anew. Returns whether it was.
/// Errors  as World::open, with nothing changed; as World::create, after which there is no world.
Result<bool> open_in(std::unique_ptr<World>& world, const SavedState& state);

/// Back to the rest state at time 0, whole and unsewn. Returns whether the world was made anew.
/// Errors  as World::reset and World::create.
Result<bool> reset_whole(std::unique_ptr<World>& world);

}  // namespace weft::sim
