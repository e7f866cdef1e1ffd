#include "sim/sewn_state.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/changed_nodes.hpp"

namespace weft::sim {
namespace {

using Sources = std::vector<std::vector<std::uint32_t>>;

/// The mean of what nodes have, by their masses.
std::vector<Vec4f> joined(const std::vector<Vec4f>& list, const Sources& from, std::span<const double> mass) {
  std::vector<Vec4f> made;
  if (list.empty()) return made;
  for (const std::vector<std::uint32_t>& nodes : from) {
    if (nodes.size() == 1) {
      made.push_back(list[nodes[0]]);
      continue;
    }
    Vec3d sum;
    double all = 0;
    for (const std::uint32_t node : nodes) {
      sum += mass[node] * list[node].xyz().to<double>();
      all += mass[node];
    }
    made.push_back(Vec4f::from((sum / all).to<float>(), 0));
  }
  return made;
}

/// A node that the scene holds stays where it is.
void carry(Snapshot& snapshot, const Model& model, const Model& then, const Sources& from) {
  std::vector<double> weight = model.mass;
  for (const std::vector<std::uint32_t>& nodes : from)
    if (std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) { return model.kinematic(node); }))
      for (const std::uint32_t node : nodes) weight[node] = model.kinematic(node) ? 1 : 0;
  for (auto* list :
       {&snapshot.position, &snapshot.velocity, &snapshot.position_before, &snapshot.velocity_before})
    *list = joined(*list, from, weight);
  for (Vec4f& velocity : snapshot.velocity) velocity.w = 0;
  std::vector<std::uint32_t> before;
  for (const std::vector<std::uint32_t>& nodes : from)
    before.push_back(nodes.size() == 1 ? nodes[0] : kNewNode);
  carry_rest(snapshot, then, before);
}

/// Of grabbed nodes that become one, the first stays grabbed; one that becomes a pinned or moved one is held by that.
void carry_grabs(std::vector<Grabbed>& grabs, const Model& model, const Model& then, const Sources& from) {
  std::vector<std::uint32_t> now(model.vertex_count());
  for (std::size_t node = 0; node < from.size(); ++node)
    for (const std::uint32_t part : from[node]) now[part] = static_cast<std::uint32_t>(node);
  std::set<std::uint32_t> held;
  std::vector<Grabbed> left;
  for (const Grabbed& grabbed : grabs) {
    const std::uint32_t node = now[grabbed.node];
    if (!then.kinematic(node) && held.insert(node).second) left.push_back({node, grabbed.target});
  }
  grabs = std::move(left);
}

/// Frames after which threads are looked at again.
std::uint32_t thread_frames(const scene::Scene& scene) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(kThreadTime / scene.time.frame)));
}

}  // namespace

Result<SewnState> sewn_state(World& world, const std::string& build) {
  SewnState made;
  const std::uint32_t frames = thread_frames(world.scene());
  if (!is_sewn(world.scene()) || world.frame() % frames != 0) return made;
  WEFT_TRY(position, places_now(world));
  const Model& model = world.model().host;
  Sewn sewn = sew(model, world.sewing(), position, world.time(), frames * world.scene().time.frame);
  made.news = std::move(sewn.news);
  if (sewn.sewing == world.sewing()) return made;
  WEFT_TRY(then, changed_model(world.scene(), world.assets(), world.tears(), sewn.sewing));
  WEFT_TRY(state, world.save(build));
  if (then.vertex_count() != model.vertex_count()) {
    const Sources from = sewn_from(model, then);
    carry(state.snapshot, model, then, from);
    carry_grabs(state.grabs, model, then, from);
  }
  state.sewing = std::move(sewn.sewing);
  made.state = std::move(state);
  return made;
}

}  // namespace weft::sim
