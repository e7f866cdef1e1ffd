// When cloth tears, and where. Source: docs/tearing.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/tears.hpp"

namespace weft {

/// The most nodes of a cloth that part before one frame, and of these the most that no tear has come to. With more of
/// them cloth that is stretched evenly falls to pieces in a frame; with one, the first tear takes load off the rest.
inline constexpr std::size_t kMostSplits = 64, kMostNewTears = 1;

struct Tearing {
  Tears tears;                      // after it
  std::vector<std::uint32_t> from;  // of each node of the torn model, the node before that it is a part of
};

/// Parts the free nodes that bear more than their cloth's strength, those that bear most first, along edges across the
/// largest tension; of two beside each other the first one. Tears go on at all their ends, and kMostNewTears begin.
/// None: no cloth tears.
/// Reads   model: torn_model of `tears`; position: of all its nodes [m].
/// Source  O'Brien and Hodgins 1999, with nodes that part along the mesh's edges instead of cut elements.
std::optional<Tearing> tear(const Model& model, const Tears& tears, std::span<const Vec3d> position);

}  // namespace weft
