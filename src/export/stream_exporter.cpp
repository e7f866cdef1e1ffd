#include "export/stream_exporter.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "mesh/little_endian.hpp"

namespace weft {
namespace {

void append(std::vector<std::byte>& bytes, const std::vector<Vec3f>& points) {
  for (const Vec3f& p : points)
    for (int axis = 0; axis < 3; ++axis) mesh::append_little_endian(bytes, p[axis]);
}

std::string stream_header(const RunMeshes& meshes) {
  std::string text = R"({"meshes": )" + parts_json(meshes.parts()) + R"(, "frames": [)";
  for (std::size_t k = 0; k < meshes.count(); ++k)
    text += (k > 0 ? "," : "") + std::to_string(meshes.frame(k));
  text += R"(], "vertices": )" + std::to_string(meshes.shape().positions.size()) + R"(, "triangles": )" +
          std::to_string(meshes.shape().triangles.size()) + R"(, "texture": )" +
          (meshes.attributes().texture.empty() ? "false}" : "true}");
  return std::to_string(text.size()) + "\n" + text;
}

class StreamExporter : public Exporter {
 public:
  StreamExporter() : Exporter("-") {}
  static Result<void> put(const void* bytes, std::size_t size) {
    if (std::fwrite(bytes, 1, size, stdout) == size) return {};
    return make_error(ErrorKind::Failure, "Standard output takes no more than a part of %zu bytes: %s.", size,
                      std::strerror(errno));
  }
  Result<void> add(const mesh::TriangleMesh& shape) override {
    std::vector<std::byte> bytes;
    append(bytes, shape.positions);
    append(bytes, mesh::smooth_normals(shape));
    return put(bytes.data(), bytes.size());
  }
  Result<void> finish() override { return {}; }
};

}  // namespace

Result<std::unique_ptr<Exporter>> make_stream_exporter(const RunMeshes& meshes) {
  const std::string header = stream_header(meshes);
  WEFT_CHECK(StreamExporter::put(header.data(), header.size()));
  std::vector<std::byte> bytes;
  for (const mesh::Triangle& triangle : meshes.shape().triangles)
    for (const std::uint32_t vertex : triangle) mesh::append_little_endian(bytes, vertex);
  for (const auto& pair : meshes.attributes().texture)
    for (const float value : pair) mesh::append_little_endian(bytes, value);
  WEFT_CHECK(StreamExporter::put(bytes.data(), bytes.size()));
  return std::unique_ptr<Exporter>(std::make_unique<StreamExporter>());
}

}  // namespace weft
