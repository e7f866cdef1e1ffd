// The meshes that a run has written into its folder, one at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "export/parts.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_attributes.hpp"

namespace weft {

/// Which of a run's meshes: of the frames `first` to `last`, the first one and every so manieth after it.
struct MeshRange {
  std::optional<std::uint32_t> first, last;
  std::uint32_t every = 1;
};

/// How a run calls the mesh of a frame: "mesh_00012.obj".
std::string mesh_name(std::uint32_t frame, const std::string& format);

class RunMeshes {
 public:
  /// Lists the files mesh_NNNNN.obj and .ply of a folder, and reads meshes.json and the first of them.
  /// Errors  Input: there is no such folder, or no mesh in the range; a file cannot be read; the first mesh is not what
  ///         meshes.json says.
  static Result<RunMeshes> open(const std::string& folder, const MeshRange& range);

  const std::string& folder() const { return folder_; }
  std::size_t count() const { return files_.size(); }
  std::uint32_t frame(std::size_t index) const { return files_[index].frame; }  // its number in the run
  /// The time from the first mesh to this one [s].
  double time(std::size_t index) const { return (files_[index].frame - files_[0].frame) * parts_.frame; }
  /// The distance between two meshes, where it is the same between all [frames].
  std::optional<std::uint32_t> spacing() const;
  const MeshParts& parts() const { return parts_; }
  /// The first mesh, with normals and what texture coordinates there are.
  const mesh::TriangleMesh& shape() const { return shape_; }
  const mesh::VertexAttributes& attributes() const { return attributes_; }

  /// One of the meshes; only its places differ from the first.
  /// Errors  Input: it cannot be read, or has not the triangles of the first.
  Result<mesh::TriangleMesh> read(std::size_t index) const;

 private:
  struct File {
    std::uint32_t frame;
    std::string path;
  };

  std::string folder_;
  std::vector<File> files_;
  MeshParts parts_;
  mesh::TriangleMesh shape_;
  mesh::VertexAttributes attributes_;

  Result<void> list(const MeshRange& range);
  Result<void> read_first();
};

}  // namespace weft
