// Which meshes of a glTF scene are where.
#pragma once

#include <cstdint>
#include <vector>

#include "base/json.hpp"
#include "base/result.hpp"
#include "base/vec.hpp"

namespace weft::mesh {

/// p -> x p.x + y p.y + z p.z + origin.
struct Affine {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;

  Vec3d direction(const Vec3d& d) const { return x * d.x + y * d.y + z * d.z; }
  Vec3d point(const Vec3d& p) const { return direction(p) + origin; }
  double determinant() const { return dot(cross(x, y), z); }
  bool operator==(const Affine&) const = default;
};

struct PlacedMesh {
  std::uint64_t node;
  std::uint64_t mesh;
  Affine placement;
};

/// The meshes of the default scene in the order in which its trees name them, parents before children.
/// Errors  Input: no scene, a node that is not there, one that is reached twice (scenes are trees), a
///         transform that is none.
Result<std::vector<PlacedMesh>> placed_meshes(const Json& document);

}  // namespace weft::mesh
