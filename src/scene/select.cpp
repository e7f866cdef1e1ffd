#include "scene/select.hpp"

#include <algorithm>
#include <cstddef>

namespace weft::scene {
namespace {

constexpr double kFaceTolerance =
    1e-9;  // m; a node meant to lie on a face is off it by rounding, far below this

bool in_part(GridPart part, std::uint32_t i, std::uint32_t j, const Selection& from) {
  const bool left = i == 0, right = i == from.nx - 1, top = j == 0, bottom = j == from.ny - 1;
  switch (part) {
    case GridPart::TopLeft:
      return top && left;
    case GridPart::TopRight:
      return top && right;
    case GridPart::BottomLeft:
      return bottom && left;
    case GridPart::BottomRight:
      return bottom && right;
    case GridPart::Top:
      return top;
    case GridPart::Bottom:
      return bottom;
    case GridPart::Left:
      return left;
    case GridPart::Right:
      return right;
    case GridPart::Corners:
      return (top || bottom) && (left || right);
    case GridPart::Edges:
      break;
  }
  return top || bottom || left || right;
}

bool in_box(const SelectorBox& box, const Vec3d& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < box.min[axis] - kFaceTolerance || p[axis] > box.max[axis] + kFaceTolerance) return false;
  return true;
}

/// A bit for each node: a thousand selectors that overlap take no more memory than one.
using Marks = std::vector<bool>;

/// Marks the nodes that pass; whether any does.
template <class Test>
bool mark_where(Marks& marked, Test test) {
  bool any = false;
  for (std::size_t node = 0; node < marked.size(); ++node)
    if (test(node)) any = marked[node] = true;
  return any;
}

/// Marks the nodes of one selector. Errors  Input: as select_nodes.
Result<void> mark_nodes(const Selector& selector, const Selection& from, Marks& marked) {
  const std::size_t count = from.positions.size();
  bool any = false;
  if (const auto* part = std::get_if<GridPart>(&selector.what)) {
    if (from.nx == 0) return input_error("%s is a part that only a grid has.", selector.where.c_str());
    assert(static_cast<std::size_t>(from.nx) * from.ny == count);
    any = mark_where(marked, [&](std::size_t node) {
      return in_part(*part, static_cast<std::uint32_t>(node % from.nx),
                     static_cast<std::uint32_t>(node / from.nx), from);
    });
  } else if (const auto* box = std::get_if<SelectorBox>(&selector.what)) {
    any = mark_where(marked, [&](std::size_t node) { return in_box(*box, from.positions[node]); });
  } else if (const auto* near = std::get_if<SelectorNear>(&selector.what)) {
    const double reach = near->radius + kFaceTolerance;
    any = mark_where(marked, [&](std::size_t node) {
      const Vec3d span = from.positions[node] - near->point;
      return dot(span, span) <= reach * reach;
    });
  } else if (const auto* list = std::get_if<SelectorNodes>(&selector.what)) {
    for (const std::uint32_t index : list->indices) {
      if (index >= count)
        return input_error("%s names node %u; there are %zu nodes, counted from 0.", selector.where.c_str(),
                           index, count);
      any = marked[index] = true;
    }
  }
  if (!any) return input_error("%s selects none of the cloth's %zu nodes.", selector.where.c_str(), count);
  return {};
}

/// Marks `nodes` as held by `holder`, unless another holds one of them already.
Result<void> hold(const std::vector<std::uint32_t>& nodes, int holder, std::vector<int>& holders,
                  const Cloth& cloth) {
  for (const std::uint32_t node : nodes) {
    const int other = holders[node];
    if (other == 0)
      return input_error(
          "%s holds node %u, which the cloth's pins hold too; a node is pinned or moved, not both.",
          cloth.motions[static_cast<std::size_t>(holder - 1)].where.c_str(), node);
    if (other > 0)
      return input_error("%s holds node %u, which motions[%d] holds too; a node follows one motion.",
                         cloth.motions[static_cast<std::size_t>(holder - 1)].where.c_str(), node, other - 1);
    holders[node] = holder;
  }
  return {};
}

}  // namespace

Result<std::vector<std::uint32_t>> select_nodes(const Selector& selector, const Selection& from) {
  return select_nodes(std::span(&selector, 1), from);
}

Result<std::vector<std::uint32_t>> select_nodes(std::span<const Selector> selectors, const Selection& from) {
  Marks marked(from.positions.size());
  for (const Selector& selector : selectors) WEFT_CHECK(mark_nodes(selector, from, marked));
  std::vector<std::uint32_t> nodes;
  nodes.reserve(static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true)));
  for (std::size_t node = 0; node < marked.size(); ++node)
    if (marked[node]) nodes.push_back(static_cast<std::uint32_t>(node));
  return nodes;
}

Result<KinematicNodes> kinematic_nodes(const Cloth& cloth, const Selection& from) {
  KinematicNodes kinematic;
  std::vector<int> holders(from.positions.size(), -1);  // 0: pins, k + 1: motion k
  WEFT_TRY(pins, select_nodes(cloth.pins, from));
  kinematic.pins = std::move(pins);
  WEFT_CHECK(hold(kinematic.pins, 0, holders, cloth));
  for (std::size_t k = 0; k < cloth.motions.size(); ++k) {
    WEFT_TRY(moved, select_nodes(cloth.motions[k].nodes, from));
    WEFT_CHECK(hold(moved, static_cast<int>(k) + 1, holders, cloth));
    kinematic.motions.push_back(std::move(moved));
  }
  return kinematic;
}

}  // namespace weft::scene
