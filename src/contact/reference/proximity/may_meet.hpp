// Whether two sides of cloth may meet on the ways of their vertices, in double.
// Source: docs/contact.md, No pass-through.
#pragma once

#include <span>

#include "contact/reference/proximity/truncate.hpp"

namespace weft::reference {

/// False: while all vertices go straight and evenly from `start` to `end` [m], a plane keeps the sides apart, by
/// pair.apart at both ends. It has the pair's normal, or turns evenly from that to the direction between the closest
/// points at the end, equation (6e).
bool may_meet(const ClothPair& pair, std::span<const Vec3d> start, std::span<const Vec3d> end);

}  // namespace weft::reference
