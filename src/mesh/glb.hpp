// Binary glTF 2.0, the one-file form of the format that most viewers and modellers exchange.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/vertex_attributes.hpp"

namespace weft::mesh {

/// A glTF file may use a mesh many times; what comes out has at most this many times the file's bytes.
constexpr std::uint64_t kMaxGlbGrowth = 100;

/// The triangles of all meshes of a GLB file's default scene, where its nodes put them [m]: lists, strips and
/// fans of float positions. glTF splits a vertex where normals or texture coordinates differ, so vertices
/// with equal bits become one (merge.hpp). Materials, skins, morph targets and animations are passed over;
/// animated_mesh.hpp reads skins and animations.
/// Errors  Input: what is wrong, with its place in the JSON; other files (URIs), Draco, meshopt, quantized or
/// sparse data, points and lines are not read. Source  Khronos, glTF 2.0 Specification.
Result<TriangleMesh> read_glb(std::span<const std::byte> bytes);

/// A GLB file of one mesh, seen from both sides, with what attributes there are. Reads back to the same positions, but
/// for vertices that coincide. The mesh passes check_mesh.
std::vector<std::byte> write_glb(const TriangleMesh& mesh, const VertexAttributes& attributes);

}  // namespace weft::mesh
