#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "export/run_meshes.hpp"

namespace weft::cli {

struct ExportOptions {
  std::string run, format, out;
  MeshRange range;
  bool quiet = false;
};

CLI::App* add_export_command(CLI::App& app, ExportOptions& options);

/// Writes the meshes of a run as an animation. The exit code.
int export_run(const ExportOptions& options);

}  // namespace weft::cli
