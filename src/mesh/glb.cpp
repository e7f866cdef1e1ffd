#include "mesh/glb.hpp"

#include <utility>

#include "mesh/glb_chunks.hpp"
#include "mesh/glb_parts.hpp"
#include "mesh/merge.hpp"

namespace weft::mesh {

Result<TriangleMesh> read_glb(std::span<const std::byte> bytes) {
  WEFT_TRY(glb, split_glb(bytes));
  WEFT_TRY(parts, read_glb_parts(glb, bytes.size(), false));
  std::vector<NodeParts> own;
  for (const SceneNode& node : parts.nodes) own.push_back(node.parts);
  const std::vector<Affine> places = placements(parts.nodes, own);
  for (const GlbRange& range : parts.ranges) {
    const Affine& placement = places[range.node];
    if (placement == Affine{}) continue;  // the bits stay
    for (std::size_t v = 0; v < range.count; ++v) {
      Vec3f& position = parts.positions[range.first + v];
      const Vec3d there = placement.point(position.to<double>());
      WEFT_CHECK(check_coordinates(there, range, v, parts.nodes[range.node]));
      position = there.to<float>();
    }
  }
  parts.turn_where([&](const GlbRange& range) { return places[range.node].determinant() < 0.0; },
                   parts.triangles);
  TriangleMesh result{std::move(parts.positions), std::move(parts.triangles)};
  WEFT_CHECK(check_mesh(result));
  merge_vertices(result);
  return result;
}

}  // namespace weft::mesh
