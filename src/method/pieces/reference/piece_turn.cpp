#include "method/pieces/reference/piece_turn.hpp"

#include "method/sym3.hpp"

namespace weft::reference {
namespace {

/// Of a piece's inertia, by its trace, beside it: one whose nodes lie in a line has none about that.
constexpr double kInertiaMargin = 4e-6;

}  // namespace

PieceTurn PieceTurn::of(std::span<const NodeMotion> nodes) {
  double mass = 0;
  Vec3d middle, gained, turned;
  for (const NodeMotion& node : nodes) {
    mass += node.mass;
    middle += node.mass * node.place;
    gained += node.mass * node.excess;
  }
  middle = middle / mass;
  Sym3 inertia;
  for (const NodeMotion& node : nodes) {
    const Vec3d arm = node.place - middle;
    inertia += Sym3::identity(node.mass * dot(arm, arm));
    inertia += Sym3::outer(arm, -node.mass);
    turned += node.mass * (cross(arm, node.excess) + node.turned);
  }
  const Vec3d whole = -1.0 * (inverse(inertia + Sym3::identity(kInertiaMargin * inertia.trace())) * turned);
  return {middle, -1.0 / mass * gained, whole / std::max(1.0, length(whole))};
}

}  // namespace weft::reference
