#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "common.hpp"

namespace weft::cli {

struct ViewOptions {
  SceneOptions scene;
  std::string view;  // what is shown first; empty: as the scene has it
  std::string adapter;
  std::string out = "out";                   // folder of what is saved and recorded
  std::uint32_t width = 1280, height = 800;  // of the window [point]
  bool paused = false, record = false;
  std::optional<std::uint32_t> frames;  // closes after so many
  std::string picture;                  // a file for the window's last picture; empty: none
};

CLI::App* add_view_command(CLI::App& app, ViewOptions& options);

/// Goes on as weft_window, the program beside this one that has the window, with the same arguments: the command line
/// itself needs no library of a window. The exit code where there is none.
int view(char** arguments);

}  // namespace weft::cli
