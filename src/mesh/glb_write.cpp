#include <cassert>
#include <cstdio>
#include <cstring>
#include <string>

#include "mesh/glb.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/little_endian.hpp"

namespace weft::mesh {
namespace {

/// Unit normals, each the sum over its triangles by area; up where there is none, since glTF asks for unit
/// length.
std::vector<Vec3f> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t[0]].to<double>();
    const Vec3d normal = cross(mesh.positions[t[1]].to<double>() - a, mesh.positions[t[2]].to<double>() - a);
    for (const std::uint32_t vertex : t) sums[vertex] += normal;
  }
  std::vector<Vec3f> normals;
  normals.reserve(sums.size());
  for (const Vec3d& sum : sums) {
    const double size = length(sum);
    normals.push_back(size > 0.0 ? (sum / size).to<float>() : Vec3f{0, 1, 0});
  }
  return normals;
}

std::string point_text(const Vec3f& p) {
  char text[64];
  std::snprintf(text, sizeof text, "[%.9g,%.9g,%.9g]", static_cast<double>(p.x), static_cast<double>(p.y),
                static_cast<double>(p.z));
  return text;
}

// Positions, normals and indices, one after the other.
std::string document(const TriangleMesh& mesh) {
  const std::size_t points = sizeof(Vec3f) * mesh.positions.size();
  const std::size_t corners = sizeof(Triangle) * mesh.triangles.size();
  const Bounds box = bounds(mesh);
  const std::string vertex_count = std::to_string(mesh.positions.size());
  const auto view = [](std::size_t offset, std::size_t size, const char* target) {
    return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
           std::to_string(size) + R"(,"target":)" + target + "}";
  };
  return R"({"asset":{"version":"2.0","generator":"weft"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0}]}],)"
         R"("materials":[{"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0}}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":)" +
         vertex_count + R"(,"type":"VEC3","min":)" + point_text(box.low) + R"(,"max":)" +
         point_text(box.high) + R"(},{"bufferView":1,"componentType":5126,"count":)" + vertex_count +
         R"(,"type":"VEC3"},{"bufferView":2,"componentType":5125,"count":)" +
         std::to_string(3 * mesh.triangles.size()) + R"(,"type":"SCALAR"}],"bufferViews":[)" +
         view(0, points, "34962") + "," + view(points, points, "34962") + "," +
         view(2 * points, corners, "34963") + R"(],"buffers":[{"byteLength":)" +
         std::to_string(2 * points + corners) + "}]}";
}

void append(std::vector<std::byte>& bytes, const std::vector<Vec3f>& points) {
  for (const Vec3f& p : points)
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &p[axis], sizeof bits);
      append_little_endian(bytes, bits);
    }
}

}  // namespace

std::vector<std::byte> write_glb(const TriangleMesh& mesh) {
  assert(check_mesh(mesh));
  std::vector<std::byte> bytes = glb_before_binary(
      document(mesh), 2 * sizeof(Vec3f) * mesh.positions.size() + sizeof(Triangle) * mesh.triangles.size());
  append(bytes, mesh.positions);
  append(bytes, vertex_normals(mesh));
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) append_little_endian(bytes, vertex);
  return bytes;
}

}  // namespace weft::mesh
