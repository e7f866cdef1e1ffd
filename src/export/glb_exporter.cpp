#include "export/glb_exporter.hpp"

#include "base/file.hpp"
#include "mesh/glb_animation.hpp"

namespace weft {
namespace {

std::vector<float> times_of(const RunMeshes& meshes) {
  std::vector<float> times;
  for (std::size_t k = 0; k < meshes.count(); ++k) times.push_back(static_cast<float>(meshes.time(k)));
  return times;
}

class GlbExporter : public Exporter {
 public:
  GlbExporter(const std::string& path, FileWriter file, mesh::GlbAnimation animation)
      : Exporter(path), file_(std::move(file)), animation_(std::move(animation)) {}

  Result<void> add(const mesh::TriangleMesh& shape) override {
    if (added_++ > 0) return file_.append(animation_.next(shape.positions, mesh::smooth_normals(shape)));
    WEFT_CHECK(file_.append(animation_.begin()));
    return file_.append(animation_.first());
  }
  Result<void> finish() override {
    for (std::size_t k = 0; k < added_; ++k) WEFT_CHECK(file_.append(animation_.weights(k)));
    WEFT_CHECK(file_.write_at(0, animation_.begin()));  // now with all bounds
    return file_.finish();
  }

 private:
  FileWriter file_;
  mesh::GlbAnimation animation_;
  std::size_t added_ = 0;
};

Error too_large(const RunMeshes& meshes, std::uint64_t bytes) {
  return make_error(ErrorKind::Limit,
                    "%zu meshes of %zu vertices take %llu bytes as GLB, more than its limit of %llu; "
                    "--every leaves meshes out, and pc2 and mdd have no such limit.",
                    meshes.count(), meshes.shape().positions.size(), static_cast<unsigned long long>(bytes),
                    static_cast<unsigned long long>(mesh::kMostGlbBytes));
}

}  // namespace

Result<std::unique_ptr<Exporter>> make_glb_exporter(const std::string& path, const RunMeshes& meshes) {
  // Before the JSON is made, which has a few hundred bytes for each mesh of each part.
  const std::uint64_t least = mesh::GlbAnimation::least_size(meshes.shape().positions.size(),
                                                             meshes.shape().triangles.size(), meshes.count());
  if (least > mesh::kMostGlbBytes) return too_large(meshes, least);
  mesh::GlbAnimation animation(meshes.shape(), meshes.attributes(), meshes.parts().parts, times_of(meshes));
  if (animation.size() > mesh::kMostGlbBytes) return too_large(meshes, animation.size());
  WEFT_TRY(file, FileWriter::create(path));
  return std::unique_ptr<Exporter>(new GlbExporter(path, std::move(file), std::move(animation)));
}

}  // namespace weft
