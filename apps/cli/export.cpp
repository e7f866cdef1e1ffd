#include "export.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "common.hpp"
#include "export/exporter.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace weft::cli {
namespace {

/// Formats for which there are libraries in Python alone.
constexpr std::string_view kOfPython[] = {"usda", "usdc", "abc"};

Result<void> check_format(const ExportOptions& options) {
  const std::string& format = options.format;
  std::vector<std::string_view> known = export_formats();
  if (format == "stream") return {};
  if (std::find(std::begin(kOfPython), std::end(kOfPython), format) != std::end(kOfPython))
    return make_error(ErrorKind::Failure,
                      "The Python package writes the format %s: after pip install 'weft[%s]', python -m weft "
                      "export %s --format %s.",
                      format.c_str(), format == "abc" ? "alembic" : "usd", options.run.c_str(),
                      format.c_str());
  known.insert(known.end(), std::begin(kOfPython), std::end(kOfPython));
  return check_names("--format", {format}, known);
}

Result<void> write_meshes(Exporter& exporter, const RunMeshes& meshes) {
  Progress progress("exporting", static_cast<std::uint32_t>(meshes.count()));
  for (std::size_t k = 0; k < meshes.count(); ++k) {
    if (interrupted())
      return make_error(ErrorKind::Interrupted, "Interrupted after %zu of %zu meshes; nothing is written.", k,
                        meshes.count());
    const auto start = std::chrono::steady_clock::now();
    WEFT_TRY(shape, meshes.read(k));
    WEFT_CHECK(exporter.add(shape));
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    progress.show(static_cast<std::uint32_t>(k + 1), spent.count());
  }
  return exporter.finish();
}

Result<void> export_meshes(const ExportOptions& options) {
  interrupted();
  WEFT_CHECK(check_format(options));
  WEFT_TRY(meshes, RunMeshes::open(options.run, options.range));
  const std::string path = options.out.empty() ? export_path(options.run, options.format) : options.out;
  WEFT_TRY(exporter, make_exporter(options.format, path, meshes));
  WEFT_CHECK(write_meshes(*exporter, meshes));
  if (!options.quiet && options.format != "stream")
    std::printf("%s: %zu meshes of %zu vertices, frames %u to %u, %.3f s\n", exporter->files().c_str(),
                meshes.count(), meshes.shape().positions.size(), meshes.frame(0),
                meshes.frame(meshes.count() - 1), meshes.time(meshes.count() - 1));
  return {};
}

}  // namespace

CLI::App* add_export_command(CLI::App& app, ExportOptions& options) {
  CLI::App* command = app.add_subcommand("export",
                                         "Example: weft export out/hanging --format glb\n\nWrite the meshes "
                                         "of a run (--meshes-every) as one animation.");
  command->add_option("RUN", options.run, "The folder of a run: weft run SCENE --out RUN --meshes-every N")
      ->required();
  command
      ->add_option("--format", options.format,
                   "glb, pc2, mdd, obj or ply; in the Python package usda, usdc or abc too")
      ->required()
      ->type_name("FORMAT");
  command->add_option("-o,--out", options.out, "The file, for obj and ply the folder; else beside RUN")
      ->type_name("PATH");
  const auto frame = [&](const char* name, std::optional<std::uint32_t>& value, const char* what) {
    command->add_option(name, value, what)
        ->check(kWholeNumber)
        ->check(CLI::Range(0U, kMostFrames))
        ->type_name("N");
  };
  frame("--first", options.range.first, "No frame before this");
  frame("--last", options.range.last, "No frame after this");
  add_every(*command, "--every", options.range.every,
            "Only the first of these meshes and every N-th after it");
  command->add_flag("-q,--quiet", options.quiet, "Do not say what was written");
  return command;
}

int export_run(const ExportOptions& options) {
  const Result<void> result = export_meshes(options);
  return result ? 0 : report(result.error());
}

}  // namespace weft::cli
