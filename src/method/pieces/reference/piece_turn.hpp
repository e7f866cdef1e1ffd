#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "method/pieces/free_pieces.hpp"
#include "method/reference_ways.hpp"

namespace weft::reference {

/// What a node of a piece adds to its sums.
struct NodeMotion {
  double mass = 0;  // [kg]
  Vec3d place;      // at the start of the substep [m]
  Vec3d excess;     // how far it has moved beyond what forces from outside give [m]
  Vec3d turned;     // its angular momentum beside that of the excess, by its mass and the step [m²]
};

/// The motion as of a rigid body that gives a piece the momentum and the angular momentum that forces from outside give
/// it. Source: docs/momentum.md.
struct PieceTurn {
  Vec3d middle, shift, turn;  // [m], [m], [rad]
  static PieceTurn of(std::span<const NodeMotion> nodes);
  /// What a node that began there is to be moved by [m].
  Vec3d at(const Vec3d& place) const { return shift + cross(turn, place - middle); }
};

/// Calls use(nodes, motions) for every piece whose nodes all go free.
template <class GoesFree, class MotionOf, class Use>
void for_each_free_piece(const FreePieces& pieces, const GoesFree& goes_free, const MotionOf& motion_of,
                         const Use& use) {
  for (std::size_t piece = 0; piece < pieces.count(); ++piece) {
    const std::span<const std::uint32_t> nodes =
        std::span(pieces.nodes)
            .subspan(pieces.starts[piece], pieces.starts[piece + 1] - pieces.starts[piece]);
    if (!std::all_of(nodes.begin(), nodes.end(), goes_free)) continue;
    std::vector<NodeMotion> motions;
    for (const std::uint32_t node : nodes) motions.push_back(motion_of(node));
    use(nodes, motions);
  }
}

/// The same for ways, of a method that knows what they are without elements, `aim` [m].
template <class GoesFree>
void keep_momentum(const FreePieces& pieces, const std::vector<Vec3d>& aim, const GoesFree& goes_free,
                   Ways& ways) {
  for_each_free_piece(
      pieces, [&](std::uint32_t node) { return ways.inverse_mass[node] > 0 && goes_free(node); },
      [&](std::uint32_t node) {
        return NodeMotion{1 / ways.inverse_mass[node], ways.start[node], ways.way[node] - aim[node], {}};
      },
      [&](std::span<const std::uint32_t> nodes, std::span<const NodeMotion> motions) {
        const PieceTurn turn = PieceTurn::of(motions);
        for (const std::uint32_t node : nodes) ways.way[node] += turn.at(ways.start[node]);
      });
}

}  // namespace weft::reference
