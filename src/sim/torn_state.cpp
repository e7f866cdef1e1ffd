#include "sim/torn_state.hpp"

#include <algorithm>

#include "model/tearing.hpp"
#include "sim/changed_nodes.hpp"

namespace weft::sim {
namespace {

template <class Element>
std::vector<Element> carried(const std::vector<Element>& list, const std::vector<std::uint32_t>& from) {
  std::vector<Element> made;
  if (list.empty()) return made;
  for (const std::uint32_t node : from) made.push_back(list[node]);
  return made;
}

void carry(Snapshot& snapshot, const Model& torn, const std::vector<std::uint32_t>& from) {
  std::vector<std::uint32_t> parts(snapshot.position.size());
  for (const std::uint32_t node : from) ++parts[node];
  snapshot.position = carried(snapshot.position, from);
  snapshot.velocity = carried(snapshot.velocity, from);
  snapshot.position_before = carried(snapshot.position_before, from);
  snapshot.velocity_before = carried(snapshot.velocity_before, from);
  std::vector<std::uint32_t> before;
  for (const std::uint32_t node : from) before.push_back(parts[node] == 1 ? node : kNewNode);
  carry_rest(snapshot, torn, before);
}

}  // namespace

Result<std::optional<SavedState>> torn_state(World& world, const std::string& build) {
  if (!can_tear(world.scene())) return std::optional<SavedState>();
  WEFT_TRY(position, places_now(world));
  auto tearing = tear(world.model().host, world.tears(), position);
  if (!tearing) return std::optional<SavedState>();
  WEFT_TRY(torn, changed_model(world.scene(), world.assets(), tearing->tears, world.sewing()));
  WEFT_TRY(state, world.save(build));
  state.tears = std::move(tearing->tears);
  carry(state.snapshot, torn, tearing->from);
  std::vector<std::uint32_t> now(world.model().vertex_count());  // the first part of each
  for (std::size_t node = tearing->from.size(); node-- > 0;)
    now[tearing->from[node]] = static_cast<std::uint32_t>(node);
  for (Grabbed& grabbed : state.grabs) grabbed.node = now[grabbed.node];
  return std::optional(std::move(state));
}

}  // namespace weft::sim
