#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common.hpp"

namespace weft::cli {

struct RunOptions {
  SceneOptions scene;
  std::optional<std::uint32_t> frames;  // none: the scene's
  std::string out;                      // folder; empty: nothing is written
  std::string adapter;
  bool json = false;
  std::string fault;  // "nan@FRAME" or "lost@FRAME": what the tests of failures bring about
};

/// Simulates a scene, draws it where there is a folder for the pictures, and says how it went. The exit code.
int run(const RunOptions& options);

}  // namespace weft::cli
