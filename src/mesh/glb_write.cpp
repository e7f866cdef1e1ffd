#include <cassert>
#include <cstdio>
#include <string>
#include <utility>

#include "mesh/glb.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/little_endian.hpp"

namespace weft::mesh {
namespace {

std::string point_text(const Vec3f& p) {
  char text[64];
  std::snprintf(text, sizeof text, "[%.9g,%.9g,%.9g]", static_cast<double>(p.x), static_cast<double>(p.y),
                static_cast<double>(p.z));
  return text;
}

/// The arrays of the file, one after the other: an accessor and a view for each, in one pass.
class Layout {
 public:
  /// `members` are those of the accessor beside its number of elements. Returns the accessor's number.
  std::size_t add(std::size_t bytes, std::size_t elements, const char* target, const std::string& members) {
    const std::string number = std::to_string(count_);
    accessors_ += (count_ > 0 ? "," : "") + (R"({"bufferView":)" + number) + R"(,"count":)" +
                  std::to_string(elements) + members + "}";
    views_ += (count_ > 0 ? "," : "") + (R"({"buffer":0,"byteOffset":)" + std::to_string(bytes_)) +
              R"(,"byteLength":)" + std::to_string(bytes) + R"(,"target":)" + target + "}";
    bytes_ += bytes;
    return count_++;
  }
  std::size_t bytes() const { return bytes_; }
  std::string text() const {
    return R"("accessors":[)" + accessors_ + R"(],"bufferViews":[)" + views_ +
           R"(],"buffers":[{"byteLength":)" + std::to_string(bytes_) + "}]";
  }

 private:
  std::string accessors_, views_;
  std::size_t count_ = 0, bytes_ = 0;
};

constexpr const char *kVertexData = "34962", *kIndexData = "34963";

/// The document, and how many bytes its arrays have: positions, what attributes there are, indices.
std::pair<std::string, std::size_t> document(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  const std::size_t vertices = mesh.positions.size(), corners = 3 * mesh.triangles.size();
  const Bounds box = bounds(mesh);
  Layout layout;
  std::string named = R"("POSITION":)" + std::to_string(layout.add(
                                             sizeof(Vec3f) * vertices, vertices, kVertexData,
                                             R"(,"componentType":5126,"type":"VEC3","min":)" +
                                                 point_text(box.low) + R"(,"max":)" + point_text(box.high)));
  if (!attributes.normals.empty())
    named += R"(,"NORMAL":)" + std::to_string(layout.add(sizeof(Vec3f) * vertices, vertices, kVertexData,
                                                         R"(,"componentType":5126,"type":"VEC3")"));
  if (!attributes.texture.empty())
    named +=
        R"(,"TEXCOORD_0":)" + std::to_string(layout.add(2 * sizeof(float) * vertices, vertices, kVertexData,
                                                        R"(,"componentType":5126,"type":"VEC2")"));
  const std::size_t indices = layout.add(sizeof(std::uint32_t) * corners, corners, kIndexData,
                                         R"(,"componentType":5125,"type":"SCALAR")");
  return {
      R"({"asset":{"version":"2.0","generator":"weft"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{)" +
          named + R"(},"indices":)" + std::to_string(indices) +
          R"(,"material":0}]}],"materials":[{"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0}}],)" +
          layout.text() + "}",
      layout.bytes()};
}

void append(std::vector<std::byte>& bytes, const std::vector<Vec3f>& points) {
  for (const Vec3f& p : points)
    for (int axis = 0; axis < 3; ++axis) append_little_endian(bytes, p[axis]);
}

}  // namespace

std::vector<std::byte> write_glb(const TriangleMesh& mesh, const VertexAttributes& attributes) {
  assert(check_mesh(mesh));
  const auto [text, size] = document(mesh, attributes);
  std::vector<std::byte> bytes = glb_before_binary(text, size);
  append(bytes, mesh.positions);
  append(bytes, attributes.normals);
  for (const auto& [u, v] : attributes.texture) {
    append_little_endian(bytes, u);
    append_little_endian(bytes, 1 - v);  // glTF counts from the upper edge of a picture
  }
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) append_little_endian(bytes, vertex);
  return bytes;
}

}  // namespace weft::mesh
