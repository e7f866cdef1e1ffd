#include "export/exporter.hpp"

#include <filesystem>

#include "export/glb_exporter.hpp"
#include "export/point_cache_exporter.hpp"
#include "export/sequence_exporter.hpp"
#include "export/stream_exporter.hpp"

namespace weft {
namespace {

using Make = Result<std::unique_ptr<Exporter>> (*)(const std::string& path, const RunMeshes& meshes);

struct Format {
  std::string_view name, end;  // of the name of its files
  Make make;
};

constexpr Format kFormats[] = {
    {"glb", ".glb", make_glb_exporter}, {"pc2", ".pc2", make_pc2_exporter},
    {"mdd", ".mdd", make_mdd_exporter}, {"obj", "_obj", make_obj_exporter},  // a folder
    {"ply", "_ply", make_ply_exporter},
};
constexpr std::string_view kStream = "stream";

}  // namespace

std::vector<std::string_view> export_formats() {
  std::vector<std::string_view> names;
  for (const Format& format : kFormats) names.push_back(format.name);
  return names;
}

std::string export_path(const std::string& run, const std::string& format) {
  std::error_code ignored;
  std::filesystem::path folder = std::filesystem::path(run).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // "out/"
  if (folder.empty() || folder.filename() == "." || folder.filename() == "..")
    folder = std::filesystem::canonical(run, ignored);
  for (const Format& one : kFormats)
    if (one.name == format) return folder.string() + std::string(one.end);
  return "-";
}

Result<std::unique_ptr<Exporter>> make_exporter(const std::string& format, const std::string& path,
                                                const RunMeshes& meshes) {
  if (format == kStream) return make_stream_exporter(meshes);
  for (const Format& one : kFormats)
    if (one.name == format) return one.make(path, meshes);
  return input_error("The format %s is not known.", format.c_str());
}

}  // namespace weft
