#include "export/point_cache_exporter.hpp"

#include <algorithm>
#include <filesystem>

#include "base/file.hpp"
#include "mesh/little_endian.hpp"
#include "mesh/obj.hpp"

namespace weft {
namespace {

using Bytes = std::vector<std::byte>;

/// Numbers of four bytes, all in the other order.
void turn(Bytes& bytes) {
  for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
    std::swap(bytes[at], bytes[at + 3]);
    std::swap(bytes[at + 1], bytes[at + 2]);
  }
}

std::string shape_path(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".obj").string();
}

class PointCacheExporter : public Exporter {
 public:
  PointCacheExporter(const std::string& path, const RunMeshes& meshes, FileWriter file, bool big_endian)
      : Exporter(path + ", " + shape_path(path)),
        shape_path_(shape_path(path)),
        meshes_(meshes),
        file_(std::move(file)),
        big_endian_(big_endian) {}

  Result<void> append(Bytes bytes) {
    if (big_endian_) turn(bytes);
    return file_.append(bytes);
  }
  Result<void> add(const mesh::TriangleMesh& shape) override {
    Bytes bytes;
    bytes.reserve(sizeof(Vec3f) * shape.positions.size());
    for (const Vec3f& p : shape.positions)
      for (int axis = 0; axis < 3; ++axis) mesh::append_little_endian(bytes, p[axis]);
    return append(std::move(bytes));
  }
  Result<void> finish() override {
    WEFT_TRY(shape, FileWriter::create(shape_path_));
    WEFT_CHECK(shape.append(mesh::write_obj(meshes_.shape(), meshes_.attributes())));
    WEFT_CHECK(file_.finish());
    return shape.finish();
  }

 private:
  std::string shape_path_;
  const RunMeshes& meshes_;
  FileWriter file_;
  bool big_endian_;
};

Result<std::unique_ptr<Exporter>> make_cache(const std::string& path, const RunMeshes& meshes,
                                             const Bytes& header, bool big_endian) {
  if (path == shape_path(path))
    return make_error(ErrorKind::Usage, "File %s would be the cache and the OBJ file of its first mesh both.",
                      path.c_str());
  WEFT_TRY(file, FileWriter::create(path));
  auto made = std::make_unique<PointCacheExporter>(path, meshes, std::move(file), big_endian);
  WEFT_CHECK(made->append(header));
  return std::unique_ptr<Exporter>(std::move(made));
}

}  // namespace

Result<std::unique_ptr<Exporter>> make_pc2_exporter(const std::string& path, const RunMeshes& meshes) {
  const auto spacing = meshes.spacing();
  if (!spacing) {
    std::size_t k = 2;
    while (meshes.frame(k) - meshes.frame(k - 1) == meshes.frame(1) - meshes.frame(0)) ++k;
    return input_error(
        "Meshes in a PC2 file are at equal distances, but those of %s are %u frames apart at frame %u and %u "
        "at frame %u; mdd and glb have times of their own.",
        meshes.folder().c_str(), meshes.frame(1) - meshes.frame(0), meshes.frame(0),
        meshes.frame(k) - meshes.frame(k - 1), meshes.frame(k - 1));
  }
  constexpr char kMagic[] = "POINTCACHE2";  // with the 0 at its end
  Bytes header;
  for (const char c : kMagic) header.push_back(static_cast<std::byte>(c));
  mesh::append_little_endian(header, std::uint32_t{1});
  mesh::append_little_endian(header, static_cast<std::uint32_t>(meshes.shape().positions.size()));
  mesh::append_little_endian(header, static_cast<float>(meshes.frame(0)));
  mesh::append_little_endian(header, static_cast<float>(*spacing));
  mesh::append_little_endian(header, static_cast<std::uint32_t>(meshes.count()));
  return make_cache(path, meshes, header, false);
}

Result<std::unique_ptr<Exporter>> make_mdd_exporter(const std::string& path, const RunMeshes& meshes) {
  Bytes header;
  mesh::append_little_endian(header, static_cast<std::uint32_t>(meshes.count()));
  mesh::append_little_endian(header, static_cast<std::uint32_t>(meshes.shape().positions.size()));
  for (std::size_t k = 0; k < meshes.count(); ++k)
    mesh::append_little_endian(header, static_cast<float>(meshes.time(k)));
  return make_cache(path, meshes, header, true);
}

}  // namespace weft
