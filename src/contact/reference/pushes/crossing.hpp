#pragma once

#include "contact/reference/box_tree.hpp"
#include "contact/reference/pushes/segment_triangle.hpp"

namespace weft::reference {

Box box_of(const TrianglePoints& triangle);
/// A cloth triangle's box, grown by 2^-21 of its largest coordinate as in triangle_pair.wgsl.
Box query_box(const TrianglePoints& cloth);

/// Whether an edge of either triangle crosses the other: exactly the rule of triangle_pair.wgsl, with
/// its tolerances, but in double. Where cloth and object are laid out evenly, edges cross right on borders,
/// and a rule without tolerance would let the last bit decide; this one takes the side that the kernels take.
/// Wherever triangle_pair() (segment_triangle.hpp) is not in doubt, the two agree.
bool triangles_cross(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace weft::reference
