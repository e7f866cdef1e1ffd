// The numbers that keep fixed-point sums of pushes from overflowing.
#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace weft::contact {

/// The largest sum at one node.
struct PushBound {
  std::uint64_t triangles_at_vertex = 0;  // the most cloth triangles that share a node
  std::uint64_t object_triangles = 0;
  std::uint64_t analytic_colliders = 0;
  std::uint64_t convex_bodies = 0;
};

/// The most triangles that share a vertex.
std::uint64_t triangles_at_vertex(const Model& model);

/// Fixed-point units per metre: the largest power of two for which no sum can leave an i32.
///
/// A node gets at most `triangles_at_vertex * (object_triangles + convex_bodies) + analytic_colliders` pushes. Each is
/// at most max_push long; as |normal| <= 1 + 2^-23 and max_push and two products are rounded to f32 (2^-24 each), a
/// component is at most max_push * scale * (1 + 2^-21) units, and rounding to an integer adds less than 1.
/// The sum over all must stay below 2^31; so does the number of pushes. Without colliders the scale is 1.
/// Within 2^-126 and 2^126, as f32 holds it.
float push_scale(const PushBound& bound, double max_push);

}  // namespace weft::contact
