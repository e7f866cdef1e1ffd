// The nodes of a glTF scene, and where they are.
#pragma once

#include <cstdint>
#include <optional>
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

Affine composed(const Affine& outer, const Affine& inner);

/// A node's own transform in parts; what is empty was not given.
struct NodeParts {
  std::vector<double> translation, rotation, scale;  // 3, 4 (x, y, z, w, of any length but 0), 3
};
/// Translation times rotation times scale.
Affine transform_of(const NodeParts& parts);

/// A node of the default scene.
struct SceneNode {
  std::uint64_t number = 0;           // in the document
  std::optional<std::size_t> parent;  // its place in the list, before its own
  NodeParts parts;
  std::optional<Affine> matrix;  // instead of parts
  std::optional<std::uint64_t> mesh, skin;
};

/// The nodes of the default scene in the order in which its trees name them, parents before children.
/// Errors  Input: no scene, a node that is not there, one that is reached twice (scenes are trees), a
///         transform that is none.
Result<std::vector<SceneNode>> scene_nodes(const Json& document);

/// Where each node is, in the scene's coordinates; `parts` are those of the nodes, or others.
std::vector<Affine> placements(const std::vector<SceneNode>& nodes, const std::vector<NodeParts>& parts);

}  // namespace weft::mesh
