#include "sim/mesh_change.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "base/words.hpp"
#include "sim/changed_nodes.hpp"
#include "sim/sewn_state.hpp"
#include "sim/torn_state.hpp"

namespace weft::sim {
namespace {

std::string sentence_of(const SeamNews& news, const World& world) {
  std::array<char, 256> text{};
  if (news.open == 0) {
    std::snprintf(text.data(), text.size(), " is sewn since frame %u.", world.frame());
  } else {
    std::snprintf(text.data(), text.size(),
                  " does not close: %s open by up to %.3g mm after %g s; threads go on to pull.",
                  counted(news.open, "pair is", "pairs are").c_str(), 1e3 * news.widest, world.time());
  }
  return news.where + text.data();
}

/// A world of the same scene, by the method that was taken when its cloth was whole.
Result<void> make_anew(std::unique_ptr<World>& world, const Tears& tears, const Sewing& sewing) {
  gpu::Device& device = world->device();
  scene::Scene scene = world->scene();
  scene.solver.kind = world->plan().method().kind;
  const Assets assets = world->assets();
  world.reset();
  WorldOptions options;
  options.tears = tears;
  options.sewing = sewing;
  WEFT_SET(world, World::create(device, std::move(scene), assets, options));
  return {};
}

/// Goes on from a state whose cloth is torn or sewn otherwise.
Result<void> go_on(std::unique_ptr<World>& world, const SavedState& state) {
  WEFT_CHECK(make_anew(world, state.tears, state.sewing));
  return world->open(state);
}

}  // namespace

bool may_change_mesh(const scene::Scene& scene) { return can_tear(scene) || is_sewn(scene); }

Result<MeshChange> change_mesh(std::unique_ptr<World>& world, const std::string& build,
                               const std::function<Result<void>()>& let_go) {
  MeshChange made;
  if (!may_change_mesh(world->scene())) return made;
  const auto change = [&](const SavedState& state) -> Result<void> {
    if (let_go && !made.changed) WEFT_CHECK(let_go());
    made.changed = true;
    return go_on(world, state);
  };
  WEFT_TRY(sewn, sewn_state(*world, build));
  for (const SeamNews& news : sewn.news) made.news.push_back(sentence_of(news, *world));
  if (sewn.state) WEFT_CHECK(change(*sewn.state));
  const bool was_whole = world->tears().splits() == 0;
  WEFT_TRY(torn, torn_state(*world, build));
  if (!torn) return made;
  if (was_whole) made.news.push_back("Cloth tears since frame " + std::to_string(world->frame()) + ".");
  WEFT_CHECK(change(*torn));
  return made;
}

Result<bool> open_in(std::unique_ptr<World>& world, const SavedState& state) {
  if (state.tears == world->tears() && state.sewing == world->sewing()) {
    WEFT_CHECK(world->open(state));
    return false;
  }
  // While there is a world still: a state from elsewhere may not be one of this scene.
  WEFT_TRY(model, changed_model(world->scene(), world->assets(), state.tears, state.sewing));
  if (model.vertex_count() != state.snapshot.position.size())
    return input_error("The state has %zu nodes, and the scene torn and sewn so %zu.",
                       state.snapshot.position.size(), model.vertex_count());
  WEFT_CHECK(go_on(world, state));
  return true;
}

Result<bool> reset_whole(std::unique_ptr<World>& world) {
  if (world->tears() == Tears{} && world->sewing() == Sewing{}) {
    WEFT_CHECK(world->reset());
    return false;
  }
  WEFT_CHECK(make_anew(world, {}, {}));
  return true;
}

}  // namespace weft::sim
