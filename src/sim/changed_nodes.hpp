// What a world whose cloth tears or is sewn takes over into the one that is made of its new mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/assets.hpp"
#include "model/sewn.hpp"
#include "model/tears.hpp"
#include "sim/snapshot.hpp"
#include "sim/world.hpp"

namespace weft::sim {

/// A scene's model once it is torn and sewn so. Errors  as build_model, torn_model and sewn_model.
Result<Model> changed_model(const scene::Scene& scene, const Assets& assets, const Tears& tears,
                            const Sewing& sewing);

/// Where all nodes are, once the frames under way have ended [m]. Errors  as World::node_state.
Result<std::vector<Vec3d>> places_now(World& world);

/// Of a node: it is no node that there was before.
inline constexpr std::uint32_t kNewNode = ~0U;

/// Once a snapshot has the places and velocities of another model's nodes: it gets their masses, and what obstacles
/// hold each with that was a node before, of the numbers `before`. Forces of pairs are forgotten.
void carry_rest(Snapshot& snapshot, const Model& then, std::span<const std::uint32_t> before);

}  // namespace weft::sim
