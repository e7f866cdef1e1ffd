// What a GLB file is of: vertices as its accessors have them, and the nodes and joints that place them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/glb_chunks.hpp"
#include "mesh/gltf_nodes.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// The joints of its skin that a vertex follows, and how much each counts; the weights sum to 1.
struct Binding {
  std::array<std::uint16_t, 4> joints{};
  std::array<float, 4> weights{};
};

/// Vertices of one accessor, as a node of the scene has them.
struct GlbRange {
  std::size_t number = 0;  // its own place among GlbParts::ranges
  std::uint64_t accessor = 0;
  std::size_t node = 0;  // its place among GlbParts::nodes
  std::size_t first = 0, count = 0;
  std::optional<std::size_t> first_binding;  // of vertices that a skin moves
};

/// Triangles of one primitive, or of several one after the other with the same vertices.
struct GlbTriangles {
  std::size_t range = 0;  // of their vertices
  std::size_t first = 0, count = 0;
};

struct GlbParts {
  std::vector<SceneNode> nodes;
  std::vector<Vec3f> positions;  // as their accessors have them
  std::vector<GlbRange> ranges;  // of the positions, in their order
  std::vector<Binding> bindings;
  std::vector<Triangle> triangles;  // as their primitives have them
  std::vector<GlbTriangles> primitives;

  /// Turns the triangles of ranges that a placement mirrors, so that their outside stays outside.
  template <class Mirrored>
  void turn_where(const Mirrored& mirrored, std::vector<Triangle>& all) const {
    for (const GlbTriangles& primitive : primitives) {
      if (!mirrored(ranges[primitive.range])) continue;
      for (std::size_t t = 0; t < primitive.count; ++t)
        std::swap(all[primitive.first + t][1], all[primitive.first + t][2]);
    }
  }
};

/// The meshes of the default scene. `skins`: with the bindings of those that skins move.
/// Errors  Input: as of read_glb (glb.hpp); with skins, joints or weights that are missing or none.
Result<GlbParts> read_glb_parts(const GlbChunks& glb, std::size_t file_size, bool skins);

/// "nodes[3]"
std::string path_of_node(const SceneNode& node);
/// Whether a vertex of a range can be where its node puts it. Errors  Input.
Result<void> check_coordinates(const Vec3d& place, const GlbRange& range, std::size_t vertex,
                               const SceneNode& node);

}  // namespace weft::mesh
