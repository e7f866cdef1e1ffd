#pragma once

#include <CLI/CLI.hpp>

#include "run.hpp"

namespace weft::cli {

/// Which scene, and what is changed in it: of run and check.
void add_scene_options(CLI::App& command, SceneOptions& options);

CLI::App* add_run_command(CLI::App& app, RunOptions& options);

}  // namespace weft::cli
