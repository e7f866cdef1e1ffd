// Meshes and the bytes of mesh files, as the tests write them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span<const char>(text.data(), text.size()));
}
inline std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The cube from 0 to 1, facing outward: 8 vertices, 12 triangles.
TriangleMesh cube();
/// Any finite bits for coordinates, any indices for triangles.
TriangleMesh random_mesh(Random& random);
bool same_bits(const TriangleMesh& a, const TriangleMesh& b);

std::string gzip(std::string_view text);
std::string text_stl(const TriangleMesh& mesh);
std::string binary_stl(const TriangleMesh& mesh, std::string_view header = "a cube");
/// A GLB container of this JSON and these bytes, each padded.
std::string glb_file(std::string json, std::string binary);
std::string text_off(const TriangleMesh& mesh);
/// A value as a PLY file of this format has it, with a space after it in a text file.
std::string ply_value(PlyFormat format, PlyType type, double value);
/// A cube in GLB as other programs write it: interleaved, indices of a byte, in a tree of nodes, and with
/// things that no mesh needs.
std::string elaborate_glb();
/// A PLY file with elements and properties that no mesh needs, in a random order.
std::string elaborate_ply(PlyFormat format, const TriangleMesh& mesh, std::uint32_t seed);

/// Flips, removes, repeats and replaces until some bytes differ, by these tokens too; whatever comes out, nothing may
/// break.
std::string changed(std::string bytes, std::span<const std::string_view> tokens, Random& random);

}  // namespace weft::mesh
