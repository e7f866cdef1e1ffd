// The triangles that a cloth can touch, as the kernels read them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::contact {

/// Mirror of ObjectTriangle in src/contact/pushes/contact_pair.wgsl. The three w are the outward unit normal.
struct ObjectTriangle {
  Vec4f a, b, c;  // [m]

  Vec3f normal() const { return {a.w, b.w, c.w}; }
};
static_assert(sizeof(ObjectTriangle) == 48);

/// An axis-aligned box [m]. Its sides are coordinates of its content, so no rounding enters.
struct Box {
  Vec3f low, high;

  bool contains(const Box& other) const {
    return min(low, other.low) == low && max(high, other.high) == high;
  }
};
Box box_of(const ObjectTriangle& triangle);
Box united(const Box& a, const Box& b);

/// The triangles of all meshes, mesh after mesh: a triangle's number here is its id in hit hashes.
/// Errors  Input: a coordinate is not finite, or a triangle has no area (mesh::drop_degenerate_triangles
/// first).
Result<std::vector<ObjectTriangle>> object_triangles(std::span<const mesh::TriangleMesh> objects);

}  // namespace weft::contact
