// A mesh that a file animates: its nodes move, and skins bend it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mesh/glb_parts.hpp"
#include "mesh/gltf_animation.hpp"

namespace weft::mesh {

class AnimatedMesh {
 public:
  /// The triangles of a GLB file's default scene, with its animations and skins. Vertices stay as its accessors have
  /// them: one that normals or texture coordinates split is several. Morph targets are passed over.
  /// Errors  Input: as of read_glb; what of skins and animations is wrong, with its path; more than four joints a
  ///         vertex.
  static Result<AnimatedMesh> read(std::span<const std::byte> bytes);

  /// The animation of a name; of "" the first. Errors  Input: the file has none, or which it has.
  Result<const GltfAnimation*> animation(const std::string& name) const;
  /// At a time of an animation of this mesh [s]: each vertex where its node, or the joints of its skin, take it
  /// (glTF 2.0, section 3.7.3.1), and triangles with their outside where that is. Errors  Input: a coordinate is not
  /// finite.
  Result<TriangleMesh> posed(const GltfAnimation& animation, double time) const;
  /// Its vertices alone.
  Result<std::vector<Vec3f>> places(const GltfAnimation& animation, double time) const;
  /// How many vertices, nodes and joints a pose goes through.
  std::size_t size() const;

 private:
  /// A joint of a skin: its place among the nodes, and where its mesh is in it at rest.
  struct Joint {
    std::size_t node = 0;
    Affine inverse_bind;
  };
  Result<void> read_skins(const GlbChunks& glb);
  Result<void> read_skin(const GlbChunks& glb, std::uint64_t number, const std::string& who);
  Result<void> check_joints() const;
  /// Where nodes are; of a range of vertices, its joints from the mesh to the scene.
  std::vector<Affine> nodes_at(const GltfAnimation& animation, double time) const;
  std::vector<Affine> joints_at(const GlbRange& range, const std::vector<Affine>& nodes) const;
  Result<std::vector<Vec3f>> placed(const std::vector<Affine>& nodes) const;

  GlbParts parts_;
  std::vector<GltfAnimation> animations_;
  std::vector<std::vector<Joint>> skins_;  // by their number in the file; empty: no node of the scene has it
};

}  // namespace weft::mesh
