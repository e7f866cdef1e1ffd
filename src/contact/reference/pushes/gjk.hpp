// The distance of a triangle and a convex body by GJK: the steps of src/contact/pushes/gjk.wgsl in double.
#pragma once

#include <cstdint>

#include "contact/reference/pushes/convex_body.hpp"

namespace weft::reference {

struct GjkContact {
  ConvexContact contact;
  std::uint32_t iterations = 0;  // of both searches, where a pair overlaps
  bool by_features = false;      // the bounds of GJK were too far apart
};

/// Gilbert, Johnson and Keerthi 1988, with the closest point of a simplex by all of its features.
GjkContact contact_by_gjk(const TrianglePoints& triangle, const ConvexBody& body);

}  // namespace weft::reference
