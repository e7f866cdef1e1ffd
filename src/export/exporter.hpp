// A run's meshes as one file of another format.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "export/run_meshes.hpp"

namespace weft {

/// Takes the meshes of a run one after the other, so that no more than one is in memory. What it writes is there under
/// its name once finish() has returned; before that, and where it is not called, there is nothing.
class Exporter {
 public:
  explicit Exporter(std::string files) : files_(std::move(files)) {}
  virtual ~Exporter() = default;
  /// The next mesh of RunMeshes, the first one included.
  virtual Result<void> add(const mesh::TriangleMesh& shape) = 0;
  virtual Result<void> finish() = 0;
  /// What it writes, as one says it.
  const std::string& files() const { return files_; }

 private:
  std::string files_;
};

/// The formats of files: "glb", "pc2", ...
std::vector<std::string_view> export_formats();

/// Where a file goes that nobody names: beside the run's folder, with its name.
std::string export_path(const std::string& run, const std::string& format);

/// `path` is "-" for the format "stream", which is no file's (stream_exporter.hpp). Reads  meshes, as long as it lives.
/// Errors  Limit: the file would be larger than its format allows. Input: the format cannot have such times, or is
///         unknown. Failure: the place cannot be written.
Result<std::unique_ptr<Exporter>> make_exporter(const std::string& format, const std::string& path,
                                                const RunMeshes& meshes);

}  // namespace weft
