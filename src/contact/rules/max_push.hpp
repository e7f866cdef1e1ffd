#pragma once

#include "model/model.hpp"

namespace weft {

/// The longest push that is believed [m]: thickness + 2 * the longest rest edge of a cloth triangle.
///
/// A push moves a node's previous position to `thickness` outside the object triangle's plane. The pair
/// intersects at the predicted positions, so a point of the cloth triangle is in that plane, and each of
/// its nodes is at most one stretched edge from it; the previous position is a substep's travel
/// further. Stretch and travel together get one more rest edge: beyond that a substep has moved a node past
/// whole triangles, and its contacts mean nothing.
double max_push(const Model& model, double thickness);

}  // namespace weft
