#include "export/run_meshes.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <tuple>

#include "base/file.hpp"
#include "base/json.hpp"
#include "mesh/gzip.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/texture.hpp"

namespace weft {
namespace {

/// The number in mesh_NNNNN.obj or mesh_NNNNN.ply.
std::optional<std::uint32_t> frame_of(const std::string& name) {
  constexpr std::size_t kBegin = 5, kEnd = 4, kMostDigits = 9;
  if (name.size() <= kBegin + kEnd || name.size() > kBegin + kMostDigits + kEnd ||
      name.rfind("mesh_", 0) != 0)
    return std::nullopt;
  const std::string end = name.substr(name.size() - kEnd);
  const std::string digits = name.substr(kBegin, name.size() - kBegin - kEnd);
  if ((end != ".obj" && end != ".ply") || digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return static_cast<std::uint32_t>(std::stoul(digits));
}

}  // namespace

std::string mesh_name(std::uint32_t frame, const std::string& format) {
  char name[32];
  std::snprintf(name, sizeof name, "mesh_%05u.", frame);
  return name + format;
}

Result<void> RunMeshes::list(const MeshRange& range) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end;
       entry.increment(error))
    if (const auto frame = frame_of(entry->path().filename().string()))
      files_.push_back({*frame, entry->path().string()});
  if (error) return input_error("Folder %s cannot be read: %s.", folder_.c_str(), error.message().c_str());
  if (files_.empty())
    return input_error(
        "Folder %s has no meshes of a run: weft run SCENE --out %s --meshes-every 1 writes them.",
        folder_.c_str(), folder_.c_str());
  std::sort(files_.begin(), files_.end(), [](const File& a, const File& b) {
    return std::tie(a.frame, a.path) < std::tie(b.frame, b.path);
  });
  const auto same = [](const File& a, const File& b) { return a.frame == b.frame; };
  files_.erase(std::unique(files_.begin(), files_.end(), same), files_.end());  // one as OBJ and PLY
  const std::uint32_t first = range.first.value_or(files_.front().frame),
                      last = range.last.value_or(files_.back().frame);
  std::vector<File> chosen;
  std::size_t inside = 0;
  for (const File& file : files_)
    if (file.frame >= first && file.frame <= last && inside++ % range.every == 0) chosen.push_back(file);
  if (chosen.empty())
    return input_error("Folder %s has no mesh of the frames %u to %u; it has those of %zu frames, %u to %u.",
                       folder_.c_str(), first, last, files_.size(), files_.front().frame,
                       files_.back().frame);
  files_ = std::move(chosen);
  return {};
}

Result<void> RunMeshes::read_first() {
  const std::string path = folder_ + "/" + kPartsFile;
  WEFT_TRY(text, read_file(path, kMaxJsonBytes));
  WEFT_SET(parts_, read_parts({reinterpret_cast<const char*>(text.data()), text.size()}, path));
  WEFT_TRY(bytes, read_file(files_[0].path, mesh::kMaxMeshBytes));
  WEFT_SET(shape_, mesh::read_mesh(bytes, files_[0].path));
  std::uint64_t vertices = 0, triangles = 0;
  for (const mesh::MeshPart& part : parts_.parts) {
    for (std::uint64_t t = triangles; t < triangles + part.triangles && t < shape_.triangles.size(); ++t)
      for (const std::uint32_t vertex : shape_.triangles[t])
        if (vertex < vertices || vertex >= vertices + part.vertices)
          return input_error("File %s has a triangle with vertex %u, which is not in part %s of %s.",
                             files_[0].path.c_str(), vertex, in_quotes(part.name).c_str(), path.c_str());
    vertices += part.vertices;
    triangles += part.triangles;
  }
  if (vertices != shape_.positions.size() || triangles != shape_.triangles.size())
    return input_error("File %s has %zu vertices and %zu triangles, but the parts of %s have %llu and %llu.",
                       files_[0].path.c_str(), shape_.positions.size(), shape_.triangles.size(), path.c_str(),
                       static_cast<unsigned long long>(vertices), static_cast<unsigned long long>(triangles));
  auto texture = mesh::read_texture(bytes, files_[0].path, shape_.positions.size());
  if (!texture) return texture.error().while_doing("reading mesh " + files_[0].path);
  attributes_.texture = std::move(*texture);
  attributes_.normals = mesh::smooth_normals(shape_);
  return {};
}

Result<RunMeshes> RunMeshes::open(const std::string& folder, const MeshRange& range) {
  RunMeshes made;
  made.folder_ = folder;
  WEFT_CHECK(made.list(range));
  WEFT_CHECK(made.read_first());
  return made;
}

std::optional<std::uint32_t> RunMeshes::spacing() const {
  if (count() < 2) return 1;
  const std::uint32_t step = frame(1) - frame(0);
  for (std::size_t k = 2; k < count(); ++k)
    if (frame(k) - frame(k - 1) != step) return std::nullopt;
  return step;
}

Result<mesh::TriangleMesh> RunMeshes::read(std::size_t index) const {
  if (index == 0) return shape_;
  const std::string& path = files_[index].path;
  WEFT_TRY(other, mesh::read_mesh(path));
  if (other.positions.size() != shape_.positions.size() || other.triangles.size() != shape_.triangles.size())
    return input_error("File %s has %zu vertices and %zu triangles, but %s, the first mesh, has %zu and %zu.",
                       path.c_str(), other.positions.size(), other.triangles.size(), files_[0].path.c_str(),
                       shape_.positions.size(), shape_.triangles.size());
  if (other.triangles != shape_.triangles)
    return input_error("File %s has other triangles than %s, the first mesh.", path.c_str(),
                       files_[0].path.c_str());
  return other;
}

}  // namespace weft
