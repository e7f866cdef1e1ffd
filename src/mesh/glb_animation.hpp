// Binary glTF of a mesh that changes its shape, written piece by piece.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh_part.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_attributes.hpp"

namespace weft::mesh {

/// The most bytes that a GLB file has: its header gives them in 32 bits, and they are a multiple of 4.
inline constexpr std::uint64_t kMostGlbBytes = 0xFFFFFFFC;

/// A GLB file of a mesh at one time or at several. The first shape is the mesh, each later one a morph target of it:
/// what its positions and normals differ by. At the time of a shape its weight is 1 and all others' are 0; between two
/// times both go linearly. Each part is a mesh, a node and a material of its name, seen from both sides.
/// The file is begin(), first(), then next() of each later shape, then weights() of each shape, the first one included.
/// Source  Khronos, glTF 2.0 Specification, 3.7.2.2 and 3.11.
class GlbAnimation {
 public:
  /// Without `parts` all is one, which has no name. `times` [s] are those of all shapes; none where nothing changes.
  GlbAnimation(const TriangleMesh& first, const VertexAttributes& attributes, std::span<const MeshPart> parts,
               std::span<const float> times);

  /// A bound for the bytes of the file, without its JSON, that needs none of its data.
  static std::uint64_t least_size(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t shapes);
  /// The bytes of the file.
  std::uint64_t size() const;

  /// What comes before the arrays. It has the bounds of all shapes that were given so far, and is as long without them.
  std::vector<std::byte> begin() const;
  std::vector<std::byte> first() const;
  /// The next shape's. Reads  as many positions and unit normals as the first shape has.
  std::vector<std::byte> next(std::span<const Vec3f> positions, std::span<const Vec3f> normals);
  std::vector<std::byte> weights(std::size_t shape) const;

 private:
  struct Layout;
  std::size_t targets() const { return times_.empty() ? 0 : times_.size() - 1; }
  void add_first(Layout& layout, std::vector<std::string>& primitives) const;
  void add_targets(Layout& layout, std::vector<std::string>& primitives) const;
  std::string add_times(Layout& layout) const;
  std::string add_animation(Layout& layout, const std::string& input) const;
  std::string document(std::uint64_t& binary_size) const;

  const TriangleMesh& first_;
  const VertexAttributes& attributes_;
  std::vector<MeshPart> parts_;
  std::vector<float> times_;
  std::vector<Bounds> bounds_;  // of each target's parts
};

}  // namespace weft::mesh
