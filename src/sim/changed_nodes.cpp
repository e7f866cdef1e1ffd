#include "sim/changed_nodes.hpp"

#include "model/attachments.hpp"

namespace weft::sim {

Result<Model> changed_model(const scene::Scene& scene, const Assets& assets, const Tears& tears,
                            const Sewing& sewing) {
  WEFT_TRY(whole, build_model(scene, assets));
  WEFT_TRY(torn, torn_model(whole, tears));
  return sewn_model(torn, sewing);
}

Result<std::vector<Vec3d>> places_now(World& world) {
  WEFT_CHECK(world.finish());
  WEFT_TRY(nodes, world.node_state());
  std::vector<Vec3d> places;
  for (const Vec4f& p : nodes.position) places.push_back(p.xyz().to<double>());
  return places;
}

void carry_rest(Snapshot& snapshot, const Model& then, std::span<const std::uint32_t> before) {
  for (auto* positions : {&snapshot.position, &snapshot.position_before})
    for (std::size_t node = 0; node < positions->size(); ++node)
      (*positions)[node].w = static_cast<float>(then.inverse_mass(node));
  snapshot.contact_forces.clear();
  if (snapshot.hold_forces.empty()) return;
  std::vector<std::int32_t> holds;
  for (const std::uint32_t node : before)
    for (std::size_t word = 0; word < kHoldWords; ++word)
      holds.push_back(node == kNewNode ? 0 : snapshot.hold_forces[kHoldWords * node + word]);
  snapshot.hold_forces = std::move(holds);
}

}  // namespace weft::sim
