// A folder as a run leaves it: two cloths whose vertices go anywhere.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "export/exporter.hpp"
#include "temporary_folder.hpp"

namespace weft {

class FakeRun {
 public:
  static constexpr double kFrame = 1.0 / 60;  // s

  /// Meshes of these frames, in this format.
  explicit FakeRun(std::vector<std::uint32_t> frames, const std::string& format = "obj");

  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string run() const { return folder_.path("run"); }
  const mesh::TriangleMesh& shape(std::size_t index) const { return shapes_[index]; }
  const std::vector<mesh::MeshPart>& parts() const { return parts_.parts; }
  const std::vector<std::array<float, 2>>& texture() const { return texture_; }

  RunMeshes open(const MeshRange& range = {}) const;
  std::string refusal(const MeshRange& range = {}) const;
  /// Exports all, and returns the bytes of the file.
  std::string bytes_of(const std::string& format, const MeshRange& range = {}) const;
  Result<void> write(const std::string& format, const std::string& file, const MeshRange& range = {}) const;
  /// The names in the folder of the run's, sorted.
  std::vector<std::string> names() const;

 private:
  TemporaryFolder folder_;
  std::vector<mesh::TriangleMesh> shapes_;
  std::vector<std::array<float, 2>> texture_;
  MeshParts parts_;
};

std::string text_of_file(const std::string& path);

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

}  // namespace weft
