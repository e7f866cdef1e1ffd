#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/animated_mesh.hpp"
#include "mesh/deformation.hpp"
#include "mesh/tet_mesh.hpp"
#include "scene/scene.hpp"

namespace weft {

/// The meshes that a scene names, read, checked and placed in the world.
struct Assets {
  std::vector<mesh::TriangleMesh> cloths;  // one for each cloth of the scene; empty for a grid or body
  std::vector<std::vector<std::uint32_t>> panels;  // of each of these how many nodes its panels have
  std::vector<mesh::TetMesh> solids;          // likewise of each body that is no block, before its transform
  std::vector<mesh::TriangleMesh> objects;    // one for each mesh, box and convex hull among the colliders
  std::vector<std::size_t> object_colliders;  // for each object its number among the scene's colliders
  std::vector<mesh::Deformation> deformations;  // of each object, placed as it is
  std::size_t dropped_triangles = 0;            // of zero area, left out of the objects
  std::size_t merged_vertices = 0;  // of the objects, that were where another one of the same mesh is
};

/// Nodes of all cloths, known before any of them is built.
std::uint64_t node_count(const scene::Scene& scene, const Assets& assets);

/// Host memory of a world per node, without its meshes. Measured in the WebAssembly module at 256² to 1024² nodes: 176;
/// of `weft check`, 183. While its shape is exported as OBJ, 305 more are allocated for a million nodes: 56 for the
/// shape with normals and texture coordinates, 249 for the text (natively, at 800² nodes, 257 are touched).
constexpr std::uint64_t kWorldBytesPerNode = 490;
/// Of fabric besides, for its elements and what the implicit solver lists of them: natively 1,640 at 512² nodes by
/// explicit steps, 3,100 at 256² by implicit ones.
constexpr std::uint64_t kFabricBytesPerNode = 3200;
/// Of a body besides, for its tetrahedra: five or six a node, each of 64 bytes as it is read and 256 in tables.
constexpr std::uint64_t kSolidBytesPerNode = 2000;

/// Whether so many bytes for each node are within `limit`, before any is built: a failed allocation ends the
/// program. `whose` memory it is goes into the sentence. Errors  Limit.
Result<void> check_memory(const scene::Scene& scene, const Assets& assets, std::uint64_t bytes_per_node,
                          std::uint64_t limit, const char* whose);

/// Errors  Input: a mesh is missing or malformed, its transform makes it too large for f32, a surface cannot be filled
///         with tetrahedra, or a keyframe has not the vertices and triangles of its collider's mesh; a file has no
///         such animation, or one that loops does not end as it begins; the points of a convex hull have no volume.
///         Limit: the shapes of an animation have more vertices than contact can number, or a convex hull has too many.
Result<Assets> load_assets(const scene::Scene& scene, const std::string& models_folder);

/// The same where meshes do not come from files: each gives the one that the scene calls by a name.
using MeshReader = std::function<Result<mesh::TriangleMesh>(const std::string& name)>;
/// Of colliders with an animation.
using AnimationReader = std::function<Result<mesh::AnimatedMesh>(const std::string& name)>;
/// Of bodies with "tetrahedra".
using TetReader = std::function<Result<mesh::TetMesh>(const std::string& name)>;
/// Errors  Input: an animation is asked for, a tetrahedral mesh is.
Result<mesh::AnimatedMesh> no_animation(const std::string& name);
Result<mesh::TetMesh> no_tetrahedra(const std::string& name);
Result<Assets> load_assets(const scene::Scene& scene, const MeshReader& read,
                           const AnimationReader& read_animated = no_animation,
                           const TetReader& read_tets = no_tetrahedra);

}  // namespace weft
