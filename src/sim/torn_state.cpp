#include "sim/torn_state.hpp"

#include <algorithm>

#include "model/attachments.hpp"
#include "model/tearing.hpp"

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
  for (auto* positions : {&snapshot.position, &snapshot.position_before})
    for (std::size_t node = 0; node < positions->size(); ++node)
      (*positions)[node].w = static_cast<float>(torn.inverse_mass(node));
  snapshot.contact_forces.clear();
  if (snapshot.hold_forces.empty()) return;
  std::vector<std::int32_t> holds;
  for (const std::uint32_t node : from)
    for (std::size_t word = 0; word < kHoldWords; ++word)
      holds.push_back(parts[node] == 1 ? snapshot.hold_forces[kHoldWords * node + word] : 0);
  snapshot.hold_forces = std::move(holds);
}

}  // namespace

Result<std::optional<SavedState>> torn_state(World& world, const std::string& build) {
  if (!can_tear(world.scene())) return std::optional<SavedState>();
  WEFT_CHECK(world.finish());
  WEFT_TRY(nodes, world.node_state());
  std::vector<Vec3d> position;
  for (const Vec4f& p : nodes.position) position.push_back(p.xyz().to<double>());
  auto tearing = tear(world.model().host, world.tears(), position);
  if (!tearing) return std::optional<SavedState>();
  WEFT_TRY(whole, build_model(world.scene(), world.assets()));
  WEFT_TRY(parted, torn_model(whole, tearing->tears));
  WEFT_TRY(torn, sewn_model(parted, world.sewing()));
  WEFT_TRY(state, world.save(build));
  state.tears = std::move(tearing->tears);
  carry(state.snapshot, torn, tearing->from);
  for (Grabbed& grabbed : state.grabs)
    grabbed.node = static_cast<std::uint32_t>(
        std::find(tearing->from.begin(), tearing->from.end(), grabbed.node) - tearing->from.begin());
  return std::optional(std::move(state));
}

}  // namespace weft::sim
