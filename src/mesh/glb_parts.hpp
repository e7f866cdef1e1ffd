// What a GLB file is of: vertices as its accessors have them, and the nodes and joints that place them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
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
  std::uint64_t accessor = 0;
  std::size_t node = 0;  // its place among GlbParts::nodes
  std::size_t first = 0, count = 0;
  std::optional<std::size_t> first_binding;  // of vertices that a skin moves
};

struct GlbParts {
  std::vector<SceneNode> nodes;
  std::vector<Vec3f> positions;  // as their accessors have them
  std::vector<GlbRange> ranges;  // of the positions, in their order
  std::vector<Binding> bindings;
  std::vector<Triangle> triangles;  // turned where its node mirrors them
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
