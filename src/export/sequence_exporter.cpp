#include "export/sequence_exporter.hpp"

#include <unistd.h>

#include <filesystem>

#include "base/file.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"

namespace weft {
namespace {

using Write = std::vector<std::byte> (*)(const mesh::TriangleMesh& mesh,
                                         const mesh::VertexAttributes& attributes);

std::vector<std::byte> ply_of(const mesh::TriangleMesh& mesh, const mesh::VertexAttributes& attributes) {
  return mesh::write_ply(mesh, {}, attributes);
}

/// Fills a folder of a temporary name.
class SequenceExporter : public Exporter {
 public:
  SequenceExporter(std::string path, const RunMeshes& meshes, std::string format, Write write)
      : Exporter(path),
        path_(std::move(path)),
        temporary_(path_ + ".tmp" + std::to_string(::getpid())),
        meshes_(meshes),
        format_(std::move(format)),
        write_(write) {}
  ~SequenceExporter() override {
    std::error_code ignored;
    if (!finished_) std::filesystem::remove_all(temporary_, ignored);
  }

  Result<void> begin() {
    WEFT_CHECK(make_folder(temporary_));
    return write_file(temporary_ + "/" + kPartsFile, parts_json(meshes_.parts()));
  }
  Result<void> add(const mesh::TriangleMesh& shape) override {
    const mesh::VertexAttributes attributes{mesh::smooth_normals(shape), meshes_.attributes().texture};
    return write_file(temporary_ + "/" + mesh_name(meshes_.frame(added_++), format_),
                      write_(shape, attributes));
  }
  Result<void> finish() override {
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error)
      return make_error(ErrorKind::Failure, "Folder %s cannot be made: %s.", path_.c_str(),
                        error.message().c_str());
    finished_ = true;
    return {};
  }

 private:
  std::string path_, temporary_;
  const RunMeshes& meshes_;
  std::string format_;
  Write write_;
  std::size_t added_ = 0;
  bool finished_ = false;
};

Result<std::unique_ptr<Exporter>> make_sequence(const std::string& path, const RunMeshes& meshes,
                                                const char* format, Write write) {
  std::error_code ignored;
  std::string folder = path;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  if (std::filesystem::exists(folder, ignored))
    return make_error(ErrorKind::Failure, "Folder %s is there already; a sequence is written into a new one.",
                      folder.c_str());
  auto made = std::make_unique<SequenceExporter>(folder, meshes, format, write);
  WEFT_CHECK(made->begin());
  return std::unique_ptr<Exporter>(std::move(made));
}

}  // namespace

Result<std::unique_ptr<Exporter>> make_obj_exporter(const std::string& path, const RunMeshes& meshes) {
  return make_sequence(path, meshes, "obj", mesh::write_obj);
}

Result<std::unique_ptr<Exporter>> make_ply_exporter(const std::string& path, const RunMeshes& meshes) {
  return make_sequence(path, meshes, "ply", ply_of);
}

}  // namespace weft
